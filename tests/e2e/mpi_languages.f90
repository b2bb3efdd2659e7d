! mpi_languages.f90 - attributes of communicators that cross from Fortran to C and back: MPI 4.0, 19.3.7.
module keys
  use mpi
  implicit none
contains
  subroutine copy(comm, key, extra, in, out, flag, ierr)
    integer :: comm, key, ierr
    integer(MPI_ADDRESS_KIND) :: extra, in, out
    logical :: flag
    print '(a,i0)', 'Fortran copies ', in
    out = in + 1
    flag = .true.
    ierr = MPI_SUCCESS
  end subroutine copy
end module keys

program languages
  use keys
  implicit none
  integer :: ierr, wide, old, made, dup, small
  integer(MPI_ADDRESS_KIND) :: number
  logical :: flag
  call MPI_Init(ierr)
  call MPI_Comm_create_keyval(copy, MPI_COMM_NULL_DELETE_FN, wide, 0_MPI_ADDRESS_KIND, ierr)
  call MPI_Keyval_create(MPI_DUP_FN, MPI_NULL_DELETE_FN, old, 0, ierr)
  call c_makes_key(made)

  call MPI_Comm_set_attr(MPI_COMM_WORLD, wide, -5000000000_MPI_ADDRESS_KIND, ierr)
  call MPI_Attr_put(MPI_COMM_WORLD, old, -7, ierr)
  call MPI_Comm_set_attr(MPI_COMM_WORLD, made, 9_MPI_ADDRESS_KIND, ierr)
  call c_gets(MPI_COMM_WORLD, wide, 1)
  call c_gets(MPI_COMM_WORLD, old, 0)
  call MPI_Comm_get_attr(MPI_COMM_WORLD, old, number, flag, ierr)
  print '(a,i0)', 'widened ', number

  call MPI_Comm_dup(MPI_COMM_WORLD, dup, ierr)
  call c_gets(dup, wide, 1)
  call c_gets(dup, old, 0)
  call MPI_Comm_get_attr(dup, made, number, flag, ierr) ! C's function has copied: a pointer
  call c_address(number)
  call MPI_Comm_free(dup, ierr)
  call MPI_Comm_delete_attr(MPI_COMM_WORLD, made, ierr)

  call c_attaches(MPI_COMM_WORLD, wide)
  call MPI_Comm_get_attr(MPI_COMM_WORLD, wide, number, flag, ierr)
  call c_address(number)
  call MPI_Attr_get(MPI_COMM_WORLD, MPI_TAG_UB, small, flag, ierr)
  print '(a,l1)', 'tags are large: ', flag .and. small > 32766
  call MPI_Finalize(ierr)
end program languages
