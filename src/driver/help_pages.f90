!> The manual page and the completion of bash, from the same tables as `--help`.
module kyvadlo_help_pages
   use kyvadlo_commands, only: commands, examples, explanations, options
   use kyvadlo_eval_requests, only: requests
   use kyvadlo_example_scenes, only: example_names
   use kyvadlo_help_topics, only: has_topic, topics
   use kyvadlo_roff, only: roff, upper_case
   use kyvadlo_text, only: text_sink_type
   use kyvadlo_version, only: licence, version
   implicit none
   private
   public :: topic_words, write_manual_page, write_completion

contains

   !> kyvadlo(1) in the man macros of roff.
   subroutine write_manual_page(sink)
      class(text_sink_type), intent(inout) :: sink
      integer :: i, j

      call sink%put('.\" Written by kyvadlo --manual-page')
      call sink%put('.TH KYVADLO 1 "" "kyvadlo '//version//'" "User Commands"')
      call sink%put('.SH NAME')
      call sink%put('kyvadlo \- exact motion of the spherical pendulum, and the elliptic functions it needs')
      call sink%put('.SH SYNOPSIS')
      do i = 1, size(commands)
         if (i > 1) call sink%put('.br')
         call sink%put('.B kyvadlo '//trim(commands(i)%name))
         call sink%put('[\fIOPTION\fR]... '//roff(trim(commands(i)%operands)))
      end do
      call sink%put('.br')
      call sink%put('.B kyvadlo')
      call sink%put('\fB\-\-help\fR | \fB\-\-version\fR')
      do i = 1, size(commands)
         call sink%put('.SH '//upper_case(trim(commands(i)%name)))
         call sink%put('Prints '//roff(trim(commands(i)%summary))//'.')
         do j = 1, size(explanations)
            if (explanations(j)%command == commands(i)%name) call sink%put(roff(trim(explanations(j)%line)))
         end do
         do j = 1, size(options)
            if (options(j)%command == commands(i)%name) call put_option(trim(options(j)%name), trim(options(j)%value), &
               trim(options(j)%meaning))
         end do
      end do
      call sink%put('.SH REQUESTS OF EVAL')
      call sink%put('Name and arguments, results, domain where it is limited.')
      do i = 1, size(requests)
         call sink%put('.TP')
         call sink%put('\fB'//roff(trim(requests(i)%name))//'\fR '//roff(trim(requests(i)%arguments)))
         if (requests(i)%domain /= '') then
            call sink%put(roff(trim(requests(i)%results))//' ('//roff(trim(requests(i)%domain))//')')
         else
            call sink%put(roff(trim(requests(i)%results)))
         end if
      end do
      call sink%put('.SH OPTIONS')
      do j = 1, size(options)
         if (options(j)%command == '' .or. options(j)%command == '-') &
            call put_option(trim(options(j)%name), trim(options(j)%value), trim(options(j)%meaning))
      end do
      call sink%put('.SH EXAMPLES')
      do i = 1, size(examples)
         call sink%put('.TP')
         call sink%put('.B '//roff(trim(examples(i)%line)))
         call sink%put(roff(trim(examples(i)%meaning)))
      end do
      call sink%put('.SH EXIT STATUS')
      call sink%put('0; 1 if a request of eval failed; 2, with one message on standard error, for wrong usage or input')
      call sink%put('or a file that cannot be read or written.')
      call sink%put('.SH SEE ALSO')
      call sink%put('.BR kyvadlo-scene (5)')
      call sink%put('.SH COPYRIGHT')
      call sink%put(roff(licence)//'.')

   contains

      subroutine put_option(name, value, meaning)
         character(len=*), intent(in) :: name, value, meaning

         call sink%put('.TP')
         if (value == '') then
            call sink%put('\fB'//roff(name)//'\fR')
         else
            call sink%put('\fB'//roff(name)//'\fR \fI'//roff(value)//'\fR')
         end if
         call sink%put(roff(meaning))
      end subroutine put_option
   end subroutine write_manual_page

   !> A script for bash: commands, options of the command, words of an option, names of eval, files elsewhere.
   subroutine write_completion(sink)
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: words
      integer :: i, j

      call sink%put('# bash completion of kyvadlo, written by kyvadlo --completion')
      call sink%put('_kyvadlo()')
      call sink%put('{')
      call sink%put('   local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]}')
      call sink%put('   local before=${COMP_WORDS[COMP_CWORD-1]}')
      call sink%put('   COMPREPLY=()')
      call sink%put('   if [ "$COMP_CWORD" -eq 1 ]; then')
      words = ''
      do i = 1, size(options)
         if (options(i)%command == '' .or. options(i)%command == '-') words = words//' '//trim(options(i)%name)
      end do
      do i = 1, size(commands)
         words = words//' '//trim(commands(i)%name)
      end do
      call sink%put('      COMPREPLY=($(compgen -W "'//words(2:)//'" -- "$word"))')
      call sink%put('      return')
      call sink%put('   fi')
      call sink%put('   case $command:$before in')
      do i = 1, size(options)
         if (index(options(i)%value, '|') == 0) cycle
         call sink%put('      '//trim(options(i)%command)//':'//trim(options(i)%name)//')')
         call sink%put('         COMPREPLY=($(compgen -W "'//blanks_for_bars(trim(options(i)%value))//'" -- "$word"))')
         call sink%put('         return ;;')
      end do
      call sink%put('   esac')
      call sink%put('   case $command:$word in')
      do i = 1, size(commands)
         words = ''
         do j = 1, size(options)
            if (options(j)%command == commands(i)%name .or. options(j)%command == '') &
               words = words//' '//trim(options(j)%name)
         end do
         call sink%put('      '//trim(commands(i)%name)//':-*)')
         call sink%put('         COMPREPLY=($(compgen -W "'//words(2:)//'" -- "$word")) ;;')
      end do
      call sink%put('      help:*) COMPREPLY=($(compgen -W "'//topic_words()//'" -- "$word")) ;;')
      words = ''
      do i = 1, size(example_names)
         words = words//' '//trim(example_names(i))
      end do
      call sink%put('      examples:*) COMPREPLY=($(compgen -W "'//words(2:)//'" -- "$word")) ;;')
      words = ''
      do i = 1, size(requests)
         words = words//' '//trim(requests(i)%name)
      end do
      call sink%put('      eval:*) COMPREPLY=($(compgen -W "'//words(2:)//'" -- "$word")) ;;')
      call sink%put('      *) COMPREPLY=($(compgen -f -- "$word")) ;;')
      call sink%put('   esac')
      call sink%put('}')
      call sink%put('complete -o filenames -F _kyvadlo kyvadlo')
   end subroutine write_completion

   !> What `help` may be asked about.
   pure function topic_words() result(words)
      character(len=:), allocatable :: words
      integer :: i

      words = ''
      do i = 1, size(topics)
         if (has_topic(trim(topics(i)%name))) words = words//' '//trim(topics(i)%name)
      end do
      do i = 1, size(commands)
         if (.not. has_topic(trim(commands(i)%name))) words = words//' '//trim(commands(i)%name)
      end do
      words = words(2:)
   end function topic_words

   pure function blanks_for_bars(text) result(words)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: words
      integer :: i

      words = text
      do i = 1, len(text)
         if (text(i:i) == '|') words(i:i) = ' '
      end do
   end function blanks_for_bars

end module kyvadlo_help_pages
