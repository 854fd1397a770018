!> Rows and columns of text as aligned text, CSV or Markdown, written line by line to a sink.
module kyvadlo_sheet
   use kyvadlo_quoting, only: csv_field
   use kyvadlo_text, only: text_sink_type, text_type
   implicit none
   private
   public :: layout_text, layout_csv, layout_markdown
   public :: sheet_type, begin_sheet, add_row, end_sheet, put_title, put_sentence, put_facts, fact_type

   integer, parameter :: layout_text = 1, layout_csv = 2, layout_markdown = 3

   !> A named value: `label  symbol  value unit`.
   type :: fact_type
      character(len=48) :: label = ''
      character(len=16) :: symbol = ''
      character(len=8) :: unit = ''
      character(len=:), allocatable :: value
   end type fact_type

   !> A table being written. The first rows wait until they show how wide the columns must be.
   type :: sheet_type
      private
      integer :: layout = layout_text
      integer :: columns = 0
      integer :: waiting = 0                       !! Rows in `cells`, the head included
      logical :: is_open = .false.                 !! The widths are decided, rows pass straight through
      integer, allocatable :: widths(:)
      type(text_type), allocatable :: cells(:,:)   !! (column, row)
   end type sheet_type

   !> So many rows wait for the widths; later ones may stick out.
   integer, parameter :: most_waiting = 200

contains

   !> Begins a table with its head.
   subroutine begin_sheet(sheet, layout, head)
      type(sheet_type), intent(out) :: sheet
      integer, intent(in) :: layout         !! One of the `layout_*` constants
      type(text_type), intent(in) :: head(:)

      sheet%layout = layout
      sheet%columns = size(head)
      allocate (sheet%widths(size(head)), source=0)
      allocate (sheet%cells(size(head), most_waiting + 1))
      sheet%waiting = 1
      sheet%cells(:, 1) = head
   end subroutine begin_sheet

   !> One row, a text for each column.
   subroutine add_row(sheet, sink, row)
      type(sheet_type), intent(inout) :: sheet
      class(text_sink_type), intent(inout) :: sink
      type(text_type), intent(in) :: row(:)

      if (sheet%is_open) then
         call put_row(sheet, sink, row)
      else
         sheet%waiting = sheet%waiting + 1
         sheet%cells(:, sheet%waiting) = row
         if (sheet%waiting > most_waiting) call open_sheet(sheet, sink)
      end if
   end subroutine add_row

   !> Writes what still waits.
   subroutine end_sheet(sheet, sink)
      type(sheet_type), intent(inout) :: sheet
      class(text_sink_type), intent(inout) :: sink

      if (.not. sheet%is_open) call open_sheet(sheet, sink)
   end subroutine end_sheet

   !> Decides the widths and lets the waiting rows go.
   subroutine open_sheet(sheet, sink)
      type(sheet_type), intent(inout) :: sheet
      class(text_sink_type), intent(inout) :: sink
      character(len=:), allocatable :: rule
      integer :: i, j

      do j = 1, sheet%waiting
         do i = 1, sheet%columns
            sheet%widths(i) = max(sheet%widths(i), letters(sheet%cells(i, j)%text))
         end do
      end do
      sheet%is_open = .true.
      do j = 1, sheet%waiting
         call put_row(sheet, sink, sheet%cells(:, j))
         if (j == 1 .and. sheet%layout == layout_markdown) then
            rule = '|'
            do i = 1, sheet%columns
               rule = rule//repeat('-', sheet%widths(i) + 1)//':|'
            end do
            call sink%put(rule)
         end if
      end do
      deallocate (sheet%cells)
   end subroutine open_sheet

   subroutine put_row(sheet, sink, row)
      type(sheet_type), intent(in) :: sheet
      class(text_sink_type), intent(inout) :: sink
      type(text_type), intent(in) :: row(:)
      character(len=:), allocatable :: line
      integer :: i

      line = ''
      do i = 1, sheet%columns
         select case (sheet%layout)
         case (layout_csv)
            if (i > 1) line = line//','
            line = line//csv_field(row(i)%text)
         case (layout_markdown)
            if (i == 1) line = '|'
            line = line//' '//right(row(i)%text, sheet%widths(i))//' |'
         case default
            if (i > 1) line = line//'  '
            line = line//right(row(i)%text, sheet%widths(i))
         end select
      end do
      call sink%put(line)
   end subroutine put_row

   !> Title of what follows. In CSV it is a column of the table instead.
   subroutine put_title(sink, layout, title)
      class(text_sink_type), intent(inout) :: sink
      integer, intent(in) :: layout
      character(len=*), intent(in) :: title

      select case (layout)
      case (layout_text)
         call sink%put(title)
         call sink%put(repeat('=', letters(title)))
      case (layout_markdown)
         call sink%put('## '//title)
         call sink%put('')
      end select
   end subroutine put_title

   !> A sentence between tables; a comment in CSV.
   subroutine put_sentence(sink, layout, sentence)
      class(text_sink_type), intent(inout) :: sink
      integer, intent(in) :: layout
      character(len=*), intent(in) :: sentence

      select case (layout)
      case (layout_csv)
         call sink%put('# '//sentence)
      case (layout_markdown)
         call sink%put(sentence)
         call sink%put('')
      case default
         call sink%put(sentence)
      end select
   end subroutine put_sentence

   !> Facts, one a line; comments in CSV.
   subroutine put_facts(sink, layout, facts)
      class(text_sink_type), intent(inout) :: sink
      integer, intent(in) :: layout
      type(fact_type), intent(in) :: facts(:)
      type(sheet_type) :: sheet
      type(text_type) :: row(4)
      integer :: i, label_width, symbol_width, value_width

      select case (layout)
      case (layout_csv)
         do i = 1, size(facts)
            call sink%put(trim('# '//trim(facts(i)%symbol)//' = '//facts(i)%value//' '//facts(i)%unit))
         end do
      case (layout_markdown)
         row(1)%text = 'quantity'
         row(2)%text = 'symbol'
         row(3)%text = 'value'
         row(4)%text = 'unit'
         call begin_sheet(sheet, layout, row)
         do i = 1, size(facts)
            row(1)%text = trim(facts(i)%label)
            row(2)%text = trim(facts(i)%symbol)
            row(3)%text = facts(i)%value
            row(4)%text = trim(facts(i)%unit)
            call add_row(sheet, sink, row)
         end do
         call end_sheet(sheet, sink)
         call sink%put('')
      case default
         label_width = 0
         symbol_width = 0
         value_width = 0
         do i = 1, size(facts)
            label_width = max(label_width, len_trim(facts(i)%label))
            symbol_width = max(symbol_width, len_trim(facts(i)%symbol))
            value_width = max(value_width, len(facts(i)%value))
         end do
         do i = 1, size(facts)
            call sink%put('  '//facts(i)%label(:label_width)//'  '//facts(i)%symbol(:symbol_width)//'  ' &
               //trim(right(facts(i)%value, value_width)//' '//facts(i)%unit))
         end do
      end select
   end subroutine put_facts

   !> Characters of a UTF-8 text: its bytes less the following ones, 10xxxxxx.
   pure integer function letters(text)
      character(len=*), intent(in) :: text
      integer :: i

      letters = 0
      do i = 1, len(text)
         if (iand(iachar(text(i:i)), 192) /= 128) letters = letters + 1
      end do
   end function letters

   !> A text moved to the right end of a field.
   pure function right(text, width) result(field)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=len(text) + max(0, width - letters(text))) :: field

      field = repeat(' ', max(0, width - letters(text)))//text
   end function right

end module kyvadlo_sheet
