!> The command `sweep`: the grid of a plan, computed by all ranks and threads there are, into one file.
module kyvadlo_sweep_command
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_command_line, only: arguments_type, integer_option, option_given, option_value
   use kyvadlo_file_text, only: fail_of_system, file_name, read_file
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_ranks
   use kyvadlo_run_files, only: add_input, add_output, check_files, is_netcdf_name, is_ordinary, run_files_type
   use kyvadlo_standard_io, only: is_terminal, message
   use kyvadlo_status, only: code_file, code_input, code_unsupported, error_type, fail
#ifdef KYVADLO_SWEEP_NETCDF
   use kyvadlo_sweep_layout
#endif
   use kyvadlo_sweep_plan, only: plan_type, read_plan
   use kyvadlo_sweep_points, only: compute_chunk
   use kyvadlo_sweep_reductions, only: chunk_type, reduction_size
   use kyvadlo_sweep_csv, only: gather_cells, write_csv
   use kyvadlo_sweep_run, only: cells_type, run_chunks
#ifndef KYVADLO_SWEEP_NETCDF
   use kyvadlo_sweep_run, only: sweep_file_type
#endif
   use kyvadlo_sweep_worker, only: new_worker, worker_type
   use kyvadlo_text, only: shown
!$ use omp_lib, only: omp_get_max_threads
   implicit none
   private
   public :: sweep_command

   !> A table larger than this is for NetCDF.
   integer(int64), parameter :: most_cells = 10000000

#ifdef KYVADLO_SWEEP_NETCDF
   logical, parameter :: with_files = .true.
#else
   logical, parameter :: with_files = .false.
#endif

   type :: request_type
      character(len=:), allocatable :: output        !! Empty: standard output
      logical :: is_netcdf = .false., is_resumed = .false., is_forced = .false., is_merge = .false.
      integer(int64) :: first = 0, last = 0          !! Chunks to compute: from, up to before
      logical :: is_part = .false.
      integer :: threads = 1
   end type request_type

   character(len=*), parameter :: by_force = 'replace it by --force'

   interface
      function kyvadlo_hold_file(path, is_new, descriptor) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: is_new
         integer(c_int), intent(out) :: descriptor
         integer(c_int) :: status
      end function kyvadlo_hold_file
      subroutine kyvadlo_let_go(descriptor) bind(c)
         import :: c_int
         integer(c_int), value :: descriptor
      end subroutine kyvadlo_let_go
      function kyvadlo_begin_sweep(unnamed, path, reserve, descriptor) bind(c) result(status)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: unnamed(*), path(*)
         integer(c_int), value :: reserve
         integer(c_int), intent(out) :: descriptor
         integer(c_int) :: status
      end function kyvadlo_begin_sweep
      function kyvadlo_kind_of_sweep(path) bind(c) result(kind)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: kind
      end function kyvadlo_kind_of_sweep
      subroutine kyvadlo_last_words(text) bind(c)
         import :: c_char
         character(kind=c_char), intent(in) :: text(*)
      end subroutine kyvadlo_last_words
      function kyvadlo_is_held(number) bind(c) result(is)
         import :: c_int
         integer(c_int), value :: number
         integer(c_int) :: is
      end function kyvadlo_is_held
   end interface

contains

   !> Runs the command. Under mpirun every rank comes here; rank 0 speaks.
   subroutine sweep_command(arguments, status, error)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status
      type(error_type), allocatable, intent(out) :: error
      type(ranks_type) :: ranks

      call start_ranks(ranks)
      call run(arguments, ranks, error)
      status = merge(2, 0, allocated(error))
      if (allocated(error) .and. ranks%rank > 0) deallocate (error)
      call end_ranks(ranks)
   end subroutine sweep_command

   subroutine run(arguments, ranks, error)
      type(arguments_type), intent(in) :: arguments
      type(ranks_type), intent(inout) :: ranks
      type(error_type), allocatable, intent(out) :: error
      type(request_type) :: request
      type(plan_type) :: plan
      type(worker_type) :: worker
      type(sweep_file_type) :: file
      type(cells_type) :: cells
      character(len=:), allocatable :: path
      integer(c_int) :: descriptor
      logical :: is_finished, shows, is_seen

      shows = is_terminal(2)
      is_seen = is_terminal(1)
      shows = shows .and. ranks%rank == 0
      descriptor = -1
      call read_request(arguments, ranks, plan, request, error)
      if (allocated(error)) return
      call new_worker(plan, worker)
      path = arguments%operands(1)%text
      if (option_given(arguments, '--explain') .and. ranks%rank == 0) call explain(plan, request, ranks, worker)
      if (.not. request%is_netcdf) then
         allocate (cells%bits(sum(plan%measures%components) + 1, plan%points), source=0_int64)
         call run_chunks(plan, compute_chunk, ranks, request%threads, request%first, request%last, .false., &
            shows .and. .not. is_seen, file, cells, error)
         call gather_cells(ranks, cells)
         if (ranks%rank == 0 .and. .not. allocated(error)) call write_csv(plan, request%output, cells, error)
         return
      end if
#ifdef KYVADLO_SWEEP_NETCDF
      ! Before there is a file: one without a whole header is begun anew.
      if (ranks%rank == 0) call kyvadlo_last_words('kyvadlo: interrupted; what is done is kept: go on with: ' &
         //'kyvadlo sweep '//path//resume_words(arguments)//new_line('a')//c_null_char)
      call prepare_file(plan, worker, request, ranks, descriptor, is_finished, error)
      if (allocated(error) .or. is_finished) return
      call open_sweep_file(plan, worker%bins, request%output, .true., file)
      file%descriptor = descriptor
      if (.not. file%is_of_plan) call fail(error, code_file, 'cannot open '//request%output)
      if (.not. allocated(error)) then
         if (request%is_merge) then
            if (ranks%rank == 0) call merge_parts(arguments, plan, worker, file, error)
         else
            call run_chunks(plan, compute_chunk, ranks, request%threads, request%first, request%last, &
               request%is_resumed, shows, file, cells, error)
         end if
      end if
      call end_run(plan, worker, request, ranks, file, error)
      call kyvadlo_let_go(descriptor)
#else
      is_finished = descriptor < 0
#endif
   end subroutine run

#ifdef KYVADLO_SWEEP_NETCDF
   !> The options that go on with the same work.
   function resume_words(arguments) result(words)
      type(arguments_type), intent(in) :: arguments
      character(len=:), allocatable :: words

      words = ' --output '//option_value(arguments, '--output', '')
      if (option_given(arguments, '--pendulum')) words = words//" --pendulum '"// &
         option_value(arguments, '--pendulum', '')//"'"
      if (option_given(arguments, '--part')) words = words//' --part '//option_value(arguments, '--part', '')
      words = words//' --resume'
   end function resume_words
#endif

   !> Reads plan and options. Errors are those of every rank.
   subroutine read_request(arguments, ranks, plan, request, error)
      type(arguments_type), intent(in) :: arguments
      type(ranks_type), intent(in) :: ranks
      type(plan_type), intent(out) :: plan
      type(request_type), intent(out) :: request
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text, path, pendulum
      integer :: code

      request%is_merge = option_given(arguments, '--merge')
      if (size(arguments%operands) < 1 .or. size(arguments%operands) > 1 .and. .not. request%is_merge) then
         call fail(error, code_input, 'sweep needs one plan, or - for standard input')
         return
      end if
      request%output = option_value(arguments, '--output', '')
      request%is_resumed = option_given(arguments, '--resume')
      request%is_forced = option_given(arguments, '--force')
      request%is_netcdf = is_netcdf_name(request%output)
      if (option_given(arguments, '--output') .and. request%output == '') then
         call fail(error, code_input, 'option --output needs the name of a file')
      else if (.not. request%is_netcdf .and. (request%is_merge .or. request%is_resumed .or. &
         option_given(arguments, '--part'))) then
         call fail(error, code_input, 'options --resume, --part and --merge need --output FILE.nc')
      else if (request%is_forced .and. request%is_resumed) then
         call fail(error, code_input, 'options --force and --resume exclude each other')
      else if (request%is_merge .and. (request%is_resumed .or. option_given(arguments, '--part'))) then
         call fail(error, code_input, 'option --merge: without --part and --resume')
      else if (request%is_netcdf .and. .not. with_files) then
         call fail(error, code_unsupported, 'cannot write '//request%output//': this build has no NetCDF ' &
            //'(libpnetcdf-dev beside MPI, else libnetcdff-dev: CMake finds it at configure time)')
      end if
      if (allocated(error)) return
      request%threads = 1
!$    if (ranks%count == 1) request%threads = omp_get_max_threads()
      code = request%threads
      call integer_option(arguments, '--threads', 0, 1024, code, error)
      if (allocated(error)) return
!$    if (code == 0) code = omp_get_max_threads()
!$    request%threads = max(code, 1)
      if (.not. ranks%may_thread) request%threads = 1
      path = arguments%operands(1)%text
      code = 0
      if (ranks%rank == 0) then
         call compare_files(arguments, request, error)
         if (.not. allocated(error)) call read_file(path, text, error)
         if (allocated(error)) code = error%code
      end if
      call share_number(code)
      if (code /= 0) then
         if (.not. allocated(error)) call fail(error, code, path)
         return
      end if
      call share_text(text)
      if (option_given(arguments, '--pendulum')) pendulum = option_value(arguments, '--pendulum', '')
      call read_plan(text, file_name(path), path(:index(path, '/', back=.true.)), plan, error, pendulum)
      if (allocated(error)) return
      if (.not. request%is_netcdf) then
         if (.not. plan%stores_values .or. size(plan%histograms) > 0) then
            call fail(error, code_input, 'a plan with &histogram needs --output FILE.nc')
         else if (plan%points > most_cells/(size(plan%axes) + sum(plan%measures%components) + 1)) then
            call fail(error, code_input, 'too many points for CSV; give --output FILE.nc')
         end if
      end if
      request%last = plan%cut%chunks
      if (option_given(arguments, '--part') .and. .not. allocated(error)) &
         call read_part(option_value(arguments, '--part', ''), plan%cut%chunks, request, error)
   end subroutine read_request

   !> No output destroys the plan or a part, nor a sheet that is there.
   subroutine compare_files(arguments, request, error)
      type(arguments_type), intent(in) :: arguments
      type(request_type), intent(in) :: request
      type(error_type), allocatable, intent(out) :: error
      type(run_files_type) :: files
      integer :: i

      do i = 1, size(arguments%operands)
         call add_input(files, merge('the plan', 'a part  ', i == 1), arguments%operands(i)%text)
      end do
      if (option_given(arguments, '--output')) call add_output(files, 'option --output', request%output)
      call check_files(files, error)
      if (allocated(error) .or. request%is_netcdf .or. request%is_forced .or. request%output == '') return
      if (is_ordinary(request%output)) call fail(error, code_file, request%output//' is there already; '//by_force)
   end subroutine compare_files

   !> `I/N`: the chunks of part I of N, which follow each other.
   subroutine read_part(text, chunks, request, error)
      character(len=*), intent(in) :: text
      integer(int64), intent(in) :: chunks
      type(request_type), intent(inout) :: request
      type(error_type), allocatable, intent(out) :: error
      integer :: slash, status, part, parts

      slash = index(text, '/')
      status = 1
      part = 0
      parts = 0
      if (slash > 1 .and. slash < len(text) .and. len(text) <= 13 .and. verify(text, '0123456789/') == 0 .and. &
         index(text, '/', back=.true.) == slash) then
         read (text(:slash - 1), *, iostat=status) part
         if (status == 0) read (text(slash + 1:), *, iostat=status) parts
      end if
      if (status /= 0 .or. part < 1 .or. part > parts .or. parts > 1000000) then
         call fail(error, code_input, "option --part must be I/N, I from 1 to N, got '"//shown(text)//"'")
         return
      end if
      request%is_part = .true.
      request%first = chunks/parts*(part - 1) + mod(chunks, int(parts, int64))*(part - 1)/parts
      request%last = chunks/parts*part + mod(chunks, int(parts, int64))*part/parts
   end subroutine read_part

#ifdef KYVADLO_SWEEP_NETCDF
   !> Makes the file, or finds it and holds it. Rank 0 does, the others hear of it.
   subroutine prepare_file(plan, worker, request, ranks, descriptor, is_finished, error)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(in) :: worker
      type(request_type), intent(inout) :: request
      type(ranks_type), intent(in) :: ranks
      integer(c_int), intent(inout) :: descriptor
      logical, intent(out) :: is_finished
      type(error_type), allocatable, intent(out) :: error
      integer :: outcome

      is_finished = .false.
      outcome = 0
      if (ranks%rank == 0) then
         call find_or_make(plan, worker, request, descriptor, is_finished, error)
         if (is_finished) outcome = 1
         if (allocated(error)) outcome = 2
         if (request%is_resumed .and. outcome == 0) outcome = 3
      end if
      call share_number(outcome)
      is_finished = outcome == 1
      request%is_resumed = outcome == 3
      if (outcome == 2 .and. .not. allocated(error)) call fail(error, code_file, request%output)
   end subroutine prepare_file

   subroutine find_or_make(plan, worker, request, descriptor, is_finished, error)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(in) :: worker
      type(request_type), intent(inout) :: request   !! On return it is resumed where there is something to go on with
      integer(c_int), intent(inout) :: descriptor
      logical, intent(out) :: is_finished
      type(error_type), allocatable, intent(out) :: error
      type(sweep_file_type) :: file
      type(error_type), allocatable :: ignored
      character(len=:), allocatable :: unnamed
      integer(c_int) :: status, old
      integer :: kind

      is_finished = .false.
      old = -1
      kind = int(kyvadlo_kind_of_sweep(request%output//c_null_char))
      if (kind >= 0 .and. .not. (request%is_resumed .or. request%is_forced)) then
         call fail(error, code_file, request%output//' is there already; go on with it by --resume, or '//by_force)
         return
      end if
      ! A new file is held from its first, empty moment on.
      status = kyvadlo_hold_file(request%output//c_null_char, merge(1_c_int, 0_c_int, kind < 0), old)
      if (kyvadlo_is_held(status) /= 0) then
         call fail(error, code_file, request%output//': another run of kyvadlo sweep writes it')
      else if (status /= 0) then
         call fail_of_system(error, 'cannot write '//request%output, int(status))
      else if (request%is_resumed .and. kind >= 0) then
         if (kind == 2) then
            call fail(error, code_file, request%output//' is no file of kyvadlo sweep')
         else
            call open_sweep_file(plan, worker%bins, request%output, .false., file)
            if (file%is_opened .and. .not. file%is_whole) then
               call fail(error, code_file, request%output//' is no file of kyvadlo sweep')
            else if (file%is_whole .and. .not. file%is_of_plan) then
               call fail(error, code_file, request%output//' is of another plan, or of another build of kyvadlo')
            else if (file%is_of_plan) then
               is_finished = is_sweep_finished(file)
            end if
            call close_sweep_file(file, ignored)
         end if
      end if
      descriptor = old
      if (allocated(error) .or. file%is_of_plan) return
      ! The header is made beside it: under the name there is never a part of one.
      request%is_resumed = .false.
      unnamed = request%output//'.kyvadlo-part'
      call create_sweep_file(plan, worker%bins, unnamed, error)
      status = 0
      if (.not. allocated(error)) status = kyvadlo_begin_sweep(unnamed//c_null_char, request%output//c_null_char, &
         merge(0_c_int, 1_c_int, request%is_part), descriptor)
      if (status /= 0) call fail_of_system(error, 'cannot write '//request%output, int(status))
      if (allocated(error)) then
         call remove_file(unnamed)
         if (kind < 0) call remove_file(request%output)
      end if
      call kyvadlo_let_go(old)
   end subroutine find_or_make

   subroutine remove_file(path)
      character(len=*), intent(in) :: path
      integer :: unit, status

      open (newunit=unit, file=path, status='old', iostat=status)
      if (status == 0) close (unit, status='delete')
   end subroutine remove_file

   !> Every chunk that a part has, from all parts.
   subroutine merge_parts(arguments, plan, worker, file, error)
      type(arguments_type), intent(in) :: arguments
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(in) :: worker
      type(sweep_file_type), intent(inout) :: file
      type(error_type), allocatable, intent(out) :: error
      type(sweep_file_type) :: part
      type(chunk_type) :: found
      integer(int64) :: chunk, first
      integer(int64), parameter :: window = 65536
      integer(int8), allocatable :: marks(:)
      integer :: i

      if (size(arguments%operands) < 2) call fail(error, code_input, &
         'option --merge needs the files of the parts behind the plan')
      allocate (found%reduction(reduction_size(worker%bins)))
      do i = 2, size(arguments%operands)
         if (allocated(error)) return
         associate (name => arguments%operands(i)%text)
            call open_sweep_file(plan, worker%bins, name, .false., part)
            if (.not. part%is_of_plan) then
               call fail(error, code_file, name//' is no part of this plan, or of another build of kyvadlo')
            else
               first = 0
               do while (first < plan%cut%chunks .and. .not. allocated(error))
                  allocate (marks(min(window, plan%cut%chunks - first)))
                  call read_marks(part, first, marks)
                  do chunk = first, first + size(marks) - 1
                     if (marks(chunk - first + 1) == 1 .and. .not. allocated(error)) &
                        call copy_chunk(plan, part, file, chunk, found, error)
                  end do
                  first = first + size(marks)
                  deallocate (marks)
               end do
               call close_sweep_file(part, error)
            end if
         end associate
      end do
   end subroutine merge_parts

   !> All ranks are through: the sums, and what is left to do.
   subroutine end_run(plan, worker, request, ranks, file, error)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(in) :: worker
      type(request_type), intent(in) :: request
      type(ranks_type), intent(in) :: ranks
      type(sweep_file_type), intent(inout) :: file
      type(error_type), allocatable, intent(inout) :: error
      integer(int64) :: missing
      integer :: failed
      character(len=24) :: number

      if (allocated(error) .and. ranks%rank > 0) call message('kyvadlo: '//error%message)
      failed = merge(1, 0, allocated(error))
      call worst_of(failed)
      if (failed > 0 .and. .not. allocated(error)) call fail(error, code_file, request%output// &
         ' is not finished; go on with --resume')
      if (ranks%rank == 0 .and. .not. allocated(error)) then
         call finish_sweep_file(plan, worker%bins, file, missing, error)
         write (number, '(i0)') missing
         if (.not. allocated(error) .and. missing > 0 .and. request%is_merge) call fail(error, code_input, &
            'the parts lack '//trim(number)//' chunks of the plan; give the others too, with --force')
      end if
      call close_sweep_file(file, error)
   end subroutine end_run
#endif

   !> What will be done and what it takes, on standard error: some chunks are tried.
   subroutine explain(plan, request, ranks, worker)
      type(plan_type), intent(in) :: plan
      type(request_type), intent(in) :: request
      type(ranks_type), intent(in) :: ranks
      type(worker_type), intent(inout) :: worker
      type(chunk_type) :: found
      integer(int64) :: points
      integer :: i, tries
      real(wp) :: begin, seconds, bytes, a_point

      points = 0
      tries = 0
      call cpu_time(begin)
      do
         call compute_chunk(plan, worker, plan%cut%chunks*tries/17, found)
         points = points + found%count
         tries = tries + 1
         call cpu_time(seconds)
         seconds = seconds - begin
         if (tries == 17 .or. seconds > 0.5_wp) exit
      end do
      a_point = seconds/points
      do i = 1, size(plan%dimensions)
         call message('dimension: '//plan%dimensions(i)%name//', '//count_text(plan%dimensions(i)%count))
      end do
      call message('points:   '//count_text(plan%points)//' in '//count_text(plan%cut%chunks)//' chunks')
      bytes = real(plan%cut%chunks, wp)*(8*reduction_size(worker%bins) + 1)
      if (plan%stores_values) bytes = bytes + real(plan%points, wp)*(1 + 8*sum(plan%measures%components, &
         plan%measures%histogram == 0))
      call message('size:     about '//digits_text(bytes, 3)//' bytes as NetCDF')
      call message('cost:     about '//digits_text(a_point*plan%points, 3)//' s of one core, '// &
         digits_text(a_point, 3)//' s a point; here '//count_text(int(ranks%count, int64))//' ranks with '// &
         count_text(int(request%threads, int64))//' threads')
   end subroutine explain

   function count_text(count) result(text)
      integer(int64), intent(in) :: count
      character(len=:), allocatable :: text
      character(len=24) :: wide

      write (wide, '(i0)') count
      text = trim(wide)
   end function count_text

end module kyvadlo_sweep_command
