!> How a table is to be written.
module kyvadlo_table_options
   use kyvadlo_sheet, only: layout_text
   implicit none
   private
   public :: table_options_type

   type :: table_options_type
      integer :: layout = layout_text  !! One of the `layout_*` constants of kyvadlo_sheet
      integer :: digits = 0            !! Significant digits; 0: two less than always survive, in CSV all that count
      integer :: divisions = 0         !! Parts of the period; 0: the paper's quarter periods
      logical :: data_only = .false.   !! Only the constants of the motion
   end type table_options_type

end module kyvadlo_table_options
