!> The words of the command line, checked against `kyvadlo_commands`, and the help pages made from it.
module kyvadlo_command_line
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_accuracy, only: accuracy_coarsest, accuracy_finest_double, accuracy_finest_quad
   use kyvadlo_commands, only: commands, examples, explanations, options
   use kyvadlo_number_text, only: digits_text, read_number
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_version, only: with_quad
   use kyvadlo_text, only: append, join, shown, text_sink_type, text_type
   implicit none
   private
   public :: arguments_type, read_command_line, sort_words, write_help, option_given, option_value, integer_option, &
      accuracy_option

   type :: arguments_type
      character(len=:), allocatable :: command          !! Empty: none given
      type(text_type), allocatable :: operands(:)       !! What is not an option
      type(text_type), allocatable :: names(:), values(:) !! Options given, with their values
   end type arguments_type

contains

   !> Reads the program's own arguments.
   subroutine read_command_line(arguments, error)
      type(arguments_type), intent(out) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: words(:)
      integer :: i, length

      allocate (words(command_argument_count()))
      do i = 1, size(words)
         call get_command_argument(i, length=length)
         allocate (character(len=length) :: words(i)%text)
         call get_command_argument(i, words(i)%text)
      end do
      call sort_words(words, arguments, error)
   end subroutine read_command_line

   !> Tells command, options and operands apart. A word that begins with `-` and a digit or point is a number; behind
   !> `--` everything is an operand.
   subroutine sort_words(words, arguments, error)
      type(text_type), intent(in) :: words(:)
      type(arguments_type), intent(out) :: arguments
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      logical :: only_operands

      arguments%command = ''
      allocate (arguments%operands(0), arguments%names(0), arguments%values(0))
      only_operands = .false.
      i = 0
      do while (i < size(words) .and. .not. allocated(error))
         i = i + 1
         if (.not. only_operands .and. words(i)%text == '--') then
            only_operands = .true.
         else if (.not. only_operands .and. looks_like_option(words(i)%text, arguments)) then
            call take_option(words, i, arguments, error)
         else if (arguments%command /= '' .or. only_operands) then
            call append(arguments%operands, words(i)%text)
         else if (any(commands%name == words(i)%text) .and. words(i)%text /= '') then
            arguments%command = words(i)%text
         else
            call fail(error, code_input, 'unknown command '//quoted(words(i)%text)//'; the commands are '// &
               command_names())
         end if
      end do
   end subroutine sort_words

   !> The option that is word number i, and its value, which may be the next word.
   subroutine take_option(words, i, arguments, error)
      type(text_type), intent(in) :: words(:)
      integer, intent(inout) :: i
      type(arguments_type), intent(inout) :: arguments
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: name, value
      integer :: j, equals

      name = words(i)%text
      if (name == '-h') name = '--help'
      equals = index(name, '=')
      if (equals > 0) then
         value = name(equals + 1:)
         name = name(:equals - 1)
      end if
      j = option_index(arguments%command, name)
      if (j == 0) then
         call fail(error, code_input, 'unknown option '//quoted(name)//see_help(arguments%command))
      else if (option_given(arguments, name)) then
         call fail(error, code_input, 'option '//name//' given twice')
      else if (options(j)%value == '') then
         if (allocated(value)) call fail(error, code_input, 'option '//name//' takes no value')
         value = ''
      else if (.not. allocated(value) .and. options(j)%value(1:1) == '[') then
         ! One of the words in brackets may follow; else it is the first.
         value = options(j)%value(2:index(options(j)%value, '|') - 1)
         if (i < size(words)) then
            if (is_choice(words(i + 1)%text, trim(options(j)%value))) then
               i = i + 1
               value = words(i)%text
            end if
         end if
      else if (.not. allocated(value)) then
         i = i + 1
         if (i > size(words)) then
            call fail(error, code_input, 'option '//name//' needs a value: '//trim(options(j)%value))
         else
            value = words(i)%text
         end if
      end if
      if (allocated(error)) return
      call append(arguments%names, name)
      call append(arguments%values, value)
      call check_word(name, value, trim(options(j)%value), error)
   end subroutine take_option

   !> Behind the NAME of eval a word with one dash is an argument, -Infinity or a mistake that eval explains.
   logical function looks_like_option(word, arguments)
      character(len=*), intent(in) :: word
      type(arguments_type), intent(in) :: arguments

      looks_like_option = .false.
      if (len(word) < 2) return
      looks_like_option = word(1:1) == '-' .and. verify(word(2:2), '0123456789.') > 0
      if (arguments%command == 'eval' .and. size(arguments%operands) > 0 .and. word /= '-h') &
         looks_like_option = looks_like_option .and. word(2:2) == '-'
   end function looks_like_option

   !> One of the words of `a|b|c`, where the option asks for that.
   subroutine check_word(name, word, choice, error)
      character(len=*), intent(in) :: name, word, choice
      type(error_type), allocatable, intent(out) :: error

      if (index(choice, '|') == 0) return
      if (is_choice(word, choice)) then
         if (word == 'quad' .and. .not. with_quad) &
            call fail(error, code_input, 'option '//name//': this build has no quadruple precision')
         return
      end if
      call fail(error, code_input, 'option '//name//' must be one of '//choice//', got '//quoted(word))
   end subroutine check_word

   !> Whether a word is one of those of `a|b|c` or `[a|b|c]`.
   pure logical function is_choice(word, choice)
      character(len=*), intent(in) :: word, choice
      integer :: first, last

      first = merge(2, 1, choice(1:1) == '[')
      last = len(choice) - first + 1
      is_choice = index('|'//choice(first:last)//'|', '|'//word//'|') > 0 .and. word /= '' .and. index(word, '|') == 0
   end function is_choice

   !> Place in `options`, or 0.
   pure integer function option_index(command, name)
      character(len=*), intent(in) :: command, name
      integer :: i

      option_index = 0
      do i = 1, size(options)
         if (options(i)%command /= command .and. options(i)%command /= '' &
            .and. .not. (command == '' .and. options(i)%command == '-')) cycle
         if (options(i)%name == name) option_index = i
      end do
   end function option_index

   !> Was this option given?
   pure logical function option_given(arguments, name)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: name
      integer :: i

      option_given = .false.
      do i = 1, size(arguments%names)
         if (arguments%names(i)%text == name) option_given = .true.
      end do
   end function option_given

   !> Value of an option, or the default.
   pure function option_value(arguments, name, default) result(value)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: name, default
      character(len=:), allocatable :: value
      integer :: i

      value = default
      do i = 1, size(arguments%values)
         if (arguments%names(i)%text == name) value = arguments%values(i)%text
      end do
   end function option_value

   !> Value of an option that counts something.
   subroutine integer_option(arguments, name, smallest, largest, value, error)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: name
      integer, intent(in) :: smallest, largest
      integer, intent(inout) :: value               !! On entry the default
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      character(len=32) :: range
      integer :: status

      if (.not. option_given(arguments, name)) return
      text = option_value(arguments, name, '')
      status = 1
      if (len(text) > 0 .and. len(text) <= 9 .and. verify(text, '0123456789') == 0) &
         read (text, '(i9)', iostat=status) value
      if (status == 0 .and. value >= smallest .and. value <= largest) return
      write (range, '(i0," to ",i0)') smallest, largest
      call fail(error, code_input, 'option '//name//' must be a whole number, '//trim(range)//', got '//quoted(text))
   end subroutine integer_option

   !> Value of --accuracy, which lies where an accuracy can be promised. It chooses the kind: who names that too
   !> contradicts himself.
   subroutine accuracy_option(arguments, accuracy, error)
      type(arguments_type), intent(in) :: arguments
      real(real64), intent(inout) :: accuracy       !! On entry the default
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: name = '--accuracy', others(2) = [character(len=8) :: '--kind', '--digits']
      !> Tables are computed in the kinds of the machine, not in pairs.
      real(real64), parameter :: finest = merge(accuracy_finest_quad, accuracy_finest_double, with_quad)
      character(len=:), allocatable :: text, what
      integer :: i

      if (.not. option_given(arguments, name)) return
      text = option_value(arguments, name, '')
      call read_number(text, accuracy, what)
      if (allocated(what)) then
         call fail(error, code_input, 'option '//name//' must be a number, got '//quoted(text)//' ('//what//')')
      else if (.not. (finest <= accuracy .and. accuracy <= accuracy_coarsest)) then
         call fail(error, code_input, 'option '//name//' must lie between '//digits_text(finest, 2)// &
            ' and '//digits_text(accuracy_coarsest, 1)//', got '//quoted(text))
      end if
      do i = 1, size(others)
         if (option_given(arguments, trim(others(i))) .and. .not. allocated(error)) &
            call fail(error, code_input, 'options '//name//' and '//trim(others(i))//' exclude each other')
      end do
   end subroutine accuracy_option

   !> The page of `kyvadlo COMMAND --help`, or of the program if there is no command.
   subroutine write_help(sink, command)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: command

      if (command == '') then
         call write_overview(sink)
      else
         call write_command_help(sink, command)
      end if
      call sink%put('')
      call sink%put('Exit status: 0; 1 if a request of eval failed; 2 with one message on standard error for wrong')
      call sink%put('usage, wrong input or a file that cannot be read or written.')
   end subroutine write_help

   subroutine write_overview(sink)
      class(text_sink_type), intent(inout) :: sink
      integer :: i

      call sink%put('Usage: kyvadlo COMMAND [OPTION]... [OPERAND]...')
      call sink%put('')
      call sink%put('The exact motion of the spherical pendulum, and elliptic functions.')
      call sink%put('')
      call sink%put('Commands:')
      do i = 1, size(commands)
         call sink%put('  '//commands(i)%name//'  '//trim(commands(i)%summary))
      end do
      call write_options(sink, '-', 16)
      call sink%put('')
      call sink%put('kyvadlo COMMAND --help prints the help of a command.')
      call write_examples(sink, '')
   end subroutine write_overview

   subroutine write_command_help(sink, command)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: command
      integer :: i

      do i = 1, size(commands)
         if (commands(i)%name /= command) cycle
         call sink%put('Usage: kyvadlo '//trim(command)//' [OPTION]... '//trim(commands(i)%operands))
         call sink%put('')
         call sink%put('Prints '//trim(commands(i)%summary)//'.')
      end do
      do i = 1, size(explanations)
         if (explanations(i)%command == command) call sink%put(trim(explanations(i)%line))
      end do
      call write_options(sink, command, 29)
      call write_examples(sink, command)
   end subroutine write_command_help

   !> The options of a command and those of every command, their meanings in one column.
   subroutine write_options(sink, command, width)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: command
      integer, intent(in) :: width
      integer :: i

      call sink%put('')
      call sink%put('Options:')
      do i = 1, size(options)
         if (options(i)%command == command .or. options(i)%command == '') &
            call sink%put('  '//padded(trim(options(i)%name)//' '//trim(options(i)%value), width)// &
               trim(options(i)%meaning))
      end do
   end subroutine write_options

   subroutine write_examples(sink, command)
      class(text_sink_type), intent(inout) :: sink
      character(len=*), intent(in) :: command   !! Empty: all
      integer :: i

      call sink%put('')
      call sink%put('Examples:')
      do i = 1, size(examples)
         if (command /= '' .and. examples(i)%command /= command) cycle
         call sink%put('  '//trim(examples(i)%line))
         call sink%put('      '//trim(examples(i)%meaning))
      end do
   end subroutine write_examples

   pure function padded(text, width) result(wide)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=max(width, len(text) + 1)) :: wide

      wide = text
   end function padded

   pure function quoted(word)
      character(len=*), intent(in) :: word
      character(len=:), allocatable :: quoted

      quoted = "'"//shown(word)//"'"
   end function quoted

   pure function see_help(command) result(text)
      character(len=*), intent(in) :: command
      character(len=:), allocatable :: text

      text = '; see kyvadlo --help'
      if (command /= '') text = '; see kyvadlo '//command//' --help'
   end function see_help

   pure function command_names() result(names)
      character(len=:), allocatable :: names
      type(text_type) :: list(size(commands))
      integer :: i

      do i = 1, size(commands)
         list(i)%text = trim(commands(i)%name)
      end do
      names = join(list, ', ')
   end function command_names

end module kyvadlo_command_line
