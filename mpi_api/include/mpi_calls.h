/* mpi_calls.h - MPI's calls that return an error code: for mpi.h, which defines MPI_DECLARE. */

/* the run */
MPI_DECLARE(Init, (int *argc, char ***argv))
MPI_DECLARE(Init_thread, (int *argc, char ***argv, int required, int *provided))
MPI_DECLARE(Initialized, (int *flag))
MPI_DECLARE(Finalize, (void))
MPI_DECLARE(Finalized, (int *flag))
MPI_DECLARE(Abort, (MPI_Comm comm, int code))
MPI_DECLARE(Query_thread, (int *provided))
MPI_DECLARE(Is_thread_main, (int *flag))
MPI_DECLARE(Get_processor_name, (char *name, int *length))
MPI_DECLARE(Get_version, (int *version, int *subversion))
MPI_DECLARE(Get_library_version, (char *version, int *length))
MPI_DECLARE(Pcontrol, (const int level, ...))
MPI_DECLARE(Alloc_mem, (MPI_Aint size, MPI_Info info, void *base))
MPI_DECLARE(Free_mem, (void *base))

/* point to point */
#define BUFFER const void *buf, int count, MPI_Datatype type
MPI_DECLARE(Send, (BUFFER, int dest, int tag, MPI_Comm comm))
MPI_DECLARE(Bsend, (BUFFER, int dest, int tag, MPI_Comm comm))
MPI_DECLARE(Ssend, (BUFFER, int dest, int tag, MPI_Comm comm))
MPI_DECLARE(Rsend, (BUFFER, int dest, int tag, MPI_Comm comm))
MPI_DECLARE(Isend, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Ibsend, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Issend, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Irsend, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Send_init, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Bsend_init, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Ssend_init, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Rsend_init, (BUFFER, int dest, int tag, MPI_Comm comm, MPI_Request *request))
#undef BUFFER
#define ROOM void *buf, int count, MPI_Datatype type
MPI_DECLARE(Recv, (ROOM, int source, int tag, MPI_Comm comm, MPI_Status *status))
MPI_DECLARE(Irecv, (ROOM, int source, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Recv_init, (ROOM, int source, int tag, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Mrecv, (ROOM, MPI_Message *message, MPI_Status *status))
MPI_DECLARE(Imrecv, (ROOM, MPI_Message *message, MPI_Request *request))
#undef ROOM
MPI_DECLARE(Sendrecv, (const void *buf, int count, MPI_Datatype type, int dest, int tag, void *into, int room,
                       MPI_Datatype as, int source, int select, MPI_Comm comm, MPI_Status *status))
MPI_DECLARE(Sendrecv_replace, (void *buf, int count, MPI_Datatype type, int dest, int tag, int source,
                               int select, MPI_Comm comm, MPI_Status *status))
MPI_DECLARE(Isendrecv,
            (const void *buf, int count, MPI_Datatype type, int dest, int tag, void *into, int room,
             MPI_Datatype as, int source, int select, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Isendrecv_replace, (void *buf, int count, MPI_Datatype type, int dest, int tag, int source,
                                int select, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Buffer_attach, (void *buf, int size))
MPI_DECLARE(Buffer_detach, (void *buf, int *size))
MPI_DECLARE(Probe, (int source, int tag, MPI_Comm comm, MPI_Status *status))
MPI_DECLARE(Iprobe, (int source, int tag, MPI_Comm comm, int *flag, MPI_Status *status))
MPI_DECLARE(Mprobe, (int source, int tag, MPI_Comm comm, MPI_Message *message, MPI_Status *status))
MPI_DECLARE(Improbe,
            (int source, int tag, MPI_Comm comm, int *flag, MPI_Message *message, MPI_Status *status))
MPI_DECLARE(Get_count, (const MPI_Status *status, MPI_Datatype type, int *count))
MPI_DECLARE(Get_elements, (const MPI_Status *status, MPI_Datatype type, int *count))
MPI_DECLARE(Get_elements_x, (const MPI_Status *status, MPI_Datatype type, MPI_Count *count))
MPI_DECLARE(Status_set_elements_x, (MPI_Status * status, MPI_Datatype type, MPI_Count count))
MPI_DECLARE(Status_set_elements, (MPI_Status * status, MPI_Datatype type, int count))
MPI_DECLARE(Status_set_cancelled, (MPI_Status * status, int flag))

/* requests */
MPI_DECLARE(Wait, (MPI_Request * request, MPI_Status *status))
MPI_DECLARE(Waitall, (int count, MPI_Request requests[], MPI_Status statuses[]))
MPI_DECLARE(Waitany, (int count, MPI_Request requests[], int *index, MPI_Status *status))
MPI_DECLARE(Waitsome, (int count, MPI_Request requests[], int *done, int indices[], MPI_Status statuses[]))
MPI_DECLARE(Test, (MPI_Request * request, int *flag, MPI_Status *status))
MPI_DECLARE(Testall, (int count, MPI_Request requests[], int *flag, MPI_Status statuses[]))
MPI_DECLARE(Testany, (int count, MPI_Request requests[], int *index, int *flag, MPI_Status *status))
MPI_DECLARE(Testsome, (int count, MPI_Request requests[], int *done, int indices[], MPI_Status statuses[]))
MPI_DECLARE(Start, (MPI_Request * request))
MPI_DECLARE(Startall, (int count, MPI_Request requests[]))
MPI_DECLARE(Request_free, (MPI_Request * request))
MPI_DECLARE(Request_get_status, (MPI_Request request, int *flag, MPI_Status *status))
MPI_DECLARE(Cancel, (MPI_Request * request))
MPI_DECLARE(Test_cancelled, (const MPI_Status *status, int *flag))
MPI_DECLARE(Grequest_start, (MPI_Grequest_query_function * query, MPI_Grequest_free_function *release,
                             MPI_Grequest_cancel_function *cancel, void *extra, MPI_Request *request))
MPI_DECLARE(Grequest_complete, (MPI_Request request))

/* datatypes */
MPI_DECLARE(Type_contiguous, (int count, MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_vector, (int count, int length, int stride, MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_hvector,
            (int count, int length, MPI_Aint stride, MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_indexed,
            (int count, const int lengths[], const int at[], MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_hindexed,
            (int count, const int lengths[], const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_indexed_block,
            (int count, int length, const int at[], MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_hindexed_block,
            (int count, int length, const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_struct, (int count, const int lengths[], const MPI_Aint at[],
                                 const MPI_Datatype types[], MPI_Datatype *type))
MPI_DECLARE(Type_create_subarray, (int dims, const int sizes[], const int subsizes[], const int starts[],
                                   int order, MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_darray,
            (int ranks, int rank, int dims, const int sizes[], const int kinds[], const int blocks[],
             const int grid[], int order, MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_create_resized, (MPI_Datatype old, MPI_Aint lb, MPI_Aint extent, MPI_Datatype *type))
MPI_DECLARE(Type_dup, (MPI_Datatype old, MPI_Datatype *type))
MPI_DECLARE(Type_commit, (MPI_Datatype * type))
MPI_DECLARE(Type_free, (MPI_Datatype * type))
MPI_DECLARE(Type_size, (MPI_Datatype type, int *size))
MPI_DECLARE(Type_size_x, (MPI_Datatype type, MPI_Count *size))
MPI_DECLARE(Type_extent, (MPI_Datatype type, MPI_Aint *extent))
MPI_DECLARE(Type_lb, (MPI_Datatype type, MPI_Aint *lb))
MPI_DECLARE(Type_ub, (MPI_Datatype type, MPI_Aint *ub))
MPI_DECLARE(Type_get_extent, (MPI_Datatype type, MPI_Aint *lb, MPI_Aint *extent))
MPI_DECLARE(Type_get_true_extent, (MPI_Datatype type, MPI_Aint *lb, MPI_Aint *extent))
MPI_DECLARE(Type_get_extent_x, (MPI_Datatype type, MPI_Count *lb, MPI_Count *extent))
MPI_DECLARE(Type_get_true_extent_x, (MPI_Datatype type, MPI_Count *lb, MPI_Count *extent))
MPI_DECLARE(Type_match_size, (int kind, int size, MPI_Datatype *type))
MPI_DECLARE(Type_create_f90_real, (int digits, int range, MPI_Datatype *type))
MPI_DECLARE(Type_create_f90_complex, (int digits, int range, MPI_Datatype *type))
MPI_DECLARE(Type_create_f90_integer, (int range, MPI_Datatype *type))
MPI_DECLARE(Type_get_envelope, (MPI_Datatype type, int *ints, int *addresses, int *types, int *combiner))
MPI_DECLARE(Type_get_contents, (MPI_Datatype type, int max_ints, int max_addresses, int max_types, int ints[],
                                MPI_Aint addresses[], MPI_Datatype types[]))
MPI_DECLARE(Type_set_name, (MPI_Datatype type, const char *name))
MPI_DECLARE(Type_get_name, (MPI_Datatype type, char *name, int *length))
MPI_DECLARE(Get_address, (const void *at, MPI_Aint *address))
MPI_DECLARE(Pack, (const void *buf, int count, MPI_Datatype type, void *into, int room, int *position,
                   MPI_Comm comm))
MPI_DECLARE(Unpack, (const void *from, int size, int *position, void *buf, int count, MPI_Datatype type,
                     MPI_Comm comm))
MPI_DECLARE(Pack_size, (int count, MPI_Datatype type, MPI_Comm comm, int *size))

MPI_DECLARE(Pack_external, (const char name[], const void *buf, int count, MPI_Datatype type, void *into,
                            MPI_Aint room, MPI_Aint *position))
MPI_DECLARE(Unpack_external, (const char name[], const void *from, MPI_Aint size, MPI_Aint *position,
                              void *buf, int count, MPI_Datatype type))
MPI_DECLARE(Pack_external_size, (const char name[], int count, MPI_Datatype type, MPI_Aint *size))

/* collectives */
#define FROM const void *buf, int count, MPI_Datatype type
#define INTO void *into, int room, MPI_Datatype as
#define FROM_EACH const void *buf, const int counts[], const int at[], MPI_Datatype type
#define INTO_EACH void *into, const int rooms[], const int places[], MPI_Datatype as
MPI_DECLARE(Barrier, (MPI_Comm comm))
MPI_DECLARE(Barrier_init, (MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ibarrier, (MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Bcast, (void *buf, int count, MPI_Datatype type, int root, MPI_Comm comm))
MPI_DECLARE(Bcast_init, (void *buf, int count, MPI_Datatype type, int root, MPI_Comm comm, MPI_Info info,
                         MPI_Request *request))
MPI_DECLARE(Ibcast, (void *buf, int count, MPI_Datatype type, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Gather, (FROM, INTO, int root, MPI_Comm comm))
MPI_DECLARE(Gather_init, (FROM, INTO, int root, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Igather, (FROM, INTO, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Gatherv, (FROM, INTO_EACH, int root, MPI_Comm comm))
MPI_DECLARE(Gatherv_init, (FROM, INTO_EACH, int root, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Igatherv, (FROM, INTO_EACH, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Scatter, (FROM, INTO, int root, MPI_Comm comm))
MPI_DECLARE(Scatter_init, (FROM, INTO, int root, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iscatter, (FROM, INTO, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Scatterv, (FROM_EACH, INTO, int root, MPI_Comm comm))
MPI_DECLARE(Scatterv_init, (FROM_EACH, INTO, int root, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iscatterv, (FROM_EACH, INTO, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Allgather, (FROM, INTO, MPI_Comm comm))
MPI_DECLARE(Allgather_init, (FROM, INTO, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iallgather, (FROM, INTO, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Allgatherv, (FROM, INTO_EACH, MPI_Comm comm))
MPI_DECLARE(Allgatherv_init, (FROM, INTO_EACH, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iallgatherv, (FROM, INTO_EACH, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Alltoall, (FROM, INTO, MPI_Comm comm))
MPI_DECLARE(Alltoall_init, (FROM, INTO, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ialltoall, (FROM, INTO, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Alltoallv, (FROM_EACH, INTO_EACH, MPI_Comm comm))
MPI_DECLARE(Alltoallv_init, (FROM_EACH, INTO_EACH, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ialltoallv, (FROM_EACH, INTO_EACH, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Alltoallw,
            (const void *buf, const int counts[], const int at[], const MPI_Datatype types[], void *into,
             const int rooms[], const int places[], const MPI_Datatype as[], MPI_Comm comm))
MPI_DECLARE(Alltoallw_init, (const void *buf, const int counts[], const int at[], const MPI_Datatype types[],
                             void *into, const int rooms[], const int places[], const MPI_Datatype as[],
                             MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ialltoallw, (const void *buf, const int counts[], const int at[], const MPI_Datatype types[],
                         void *into, const int rooms[], const int places[], const MPI_Datatype as[],
                         MPI_Comm comm, MPI_Request *request))
#undef FROM
#undef INTO
#undef FROM_EACH
#undef INTO_EACH
#define OPERANDS const void *buf, void *into, int count, MPI_Datatype type, MPI_Op op
MPI_DECLARE(Reduce, (OPERANDS, int root, MPI_Comm comm))
MPI_DECLARE(Reduce_init, (OPERANDS, int root, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ireduce, (OPERANDS, int root, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Allreduce, (OPERANDS, MPI_Comm comm))
MPI_DECLARE(Allreduce_init, (OPERANDS, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iallreduce, (OPERANDS, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Scan, (OPERANDS, MPI_Comm comm))
MPI_DECLARE(Scan_init, (OPERANDS, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iscan, (OPERANDS, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Exscan, (OPERANDS, MPI_Comm comm))
MPI_DECLARE(Exscan_init, (OPERANDS, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Iexscan, (OPERANDS, MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Reduce_scatter_block, (OPERANDS, MPI_Comm comm))
MPI_DECLARE(Reduce_scatter_block_init, (OPERANDS, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ireduce_scatter_block, (OPERANDS, MPI_Comm comm, MPI_Request *request))
#undef OPERANDS
MPI_DECLARE(Reduce_scatter,
            (const void *buf, void *into, const int counts[], MPI_Datatype type, MPI_Op op, MPI_Comm comm))
MPI_DECLARE(Reduce_scatter_init, (const void *buf, void *into, const int counts[], MPI_Datatype type,
                                  MPI_Op op, MPI_Comm comm, MPI_Info info, MPI_Request *request))
MPI_DECLARE(Ireduce_scatter, (const void *buf, void *into, const int counts[], MPI_Datatype type, MPI_Op op,
                              MPI_Comm comm, MPI_Request *request))
MPI_DECLARE(Reduce_local, (const void *in, void *inout, int count, MPI_Datatype type, MPI_Op op))
MPI_DECLARE(Op_create, (MPI_User_function * function, int commutes, MPI_Op *op))
MPI_DECLARE(Op_free, (MPI_Op * op))
MPI_DECLARE(Op_commutative, (MPI_Op op, int *commutes))

/* groups */
MPI_DECLARE(Group_size, (MPI_Group group, int *size))
MPI_DECLARE(Group_rank, (MPI_Group group, int *rank))
MPI_DECLARE(Group_translate_ranks,
            (MPI_Group from, int count, const int ranks[], MPI_Group to, int translated[]))
MPI_DECLARE(Group_compare, (MPI_Group a, MPI_Group b, int *result))
MPI_DECLARE(Group_union, (MPI_Group a, MPI_Group b, MPI_Group *group))
MPI_DECLARE(Group_intersection, (MPI_Group a, MPI_Group b, MPI_Group *group))
MPI_DECLARE(Group_difference, (MPI_Group a, MPI_Group b, MPI_Group *group))
MPI_DECLARE(Group_incl, (MPI_Group from, int count, const int ranks[], MPI_Group *group))
MPI_DECLARE(Group_excl, (MPI_Group from, int count, const int ranks[], MPI_Group *group))
MPI_DECLARE(Group_range_incl, (MPI_Group from, int count, int ranges[][3], MPI_Group *group))
MPI_DECLARE(Group_range_excl, (MPI_Group from, int count, int ranges[][3], MPI_Group *group))
MPI_DECLARE(Group_free, (MPI_Group * group))

/* communicators */
MPI_DECLARE(Comm_size, (MPI_Comm comm, int *size))
MPI_DECLARE(Comm_rank, (MPI_Comm comm, int *rank))
MPI_DECLARE(Comm_compare, (MPI_Comm a, MPI_Comm b, int *result))
MPI_DECLARE(Comm_group, (MPI_Comm comm, MPI_Group *group))
MPI_DECLARE(Comm_dup, (MPI_Comm comm, MPI_Comm *to))
MPI_DECLARE(Comm_dup_with_info, (MPI_Comm comm, MPI_Info info, MPI_Comm *to))
MPI_DECLARE(Comm_idup, (MPI_Comm comm, MPI_Comm *to, MPI_Request *request))
MPI_DECLARE(Comm_idup_with_info, (MPI_Comm comm, MPI_Info info, MPI_Comm *to, MPI_Request *request))
MPI_DECLARE(Comm_create, (MPI_Comm comm, MPI_Group group, MPI_Comm *to))
MPI_DECLARE(Comm_create_group, (MPI_Comm comm, MPI_Group group, int tag, MPI_Comm *to))
MPI_DECLARE(Comm_split, (MPI_Comm comm, int color, int key, MPI_Comm *to))
MPI_DECLARE(Comm_split_type, (MPI_Comm comm, int kind, int key, MPI_Info info, MPI_Comm *to))
MPI_DECLARE(Comm_free, (MPI_Comm * comm))
MPI_DECLARE(Comm_disconnect, (MPI_Comm * comm))
MPI_DECLARE(Comm_get_parent, (MPI_Comm * parent))
MPI_DECLARE(Comm_set_name, (MPI_Comm comm, const char *name))
MPI_DECLARE(Comm_get_name, (MPI_Comm comm, char *name, int *length))
MPI_DECLARE(Comm_set_info, (MPI_Comm comm, MPI_Info info))
MPI_DECLARE(Comm_get_info, (MPI_Comm comm, MPI_Info *info))
MPI_DECLARE(Comm_test_inter, (MPI_Comm comm, int *flag))
MPI_DECLARE(Comm_remote_size, (MPI_Comm comm, int *size))
MPI_DECLARE(Comm_remote_group, (MPI_Comm comm, MPI_Group *group))
MPI_DECLARE(Intercomm_create,
            (MPI_Comm local, int leader, MPI_Comm bridge, int remote_leader, int tag, MPI_Comm *to))
MPI_DECLARE(Intercomm_merge, (MPI_Comm comm, int high, MPI_Comm *to))
MPI_DECLARE(Comm_create_keyval, (MPI_Comm_copy_attr_function * copy, MPI_Comm_delete_attr_function *drop,
                                 int *keyval, void *extra))
MPI_DECLARE(Comm_free_keyval, (int *keyval))
MPI_DECLARE(Comm_set_attr, (MPI_Comm comm, int keyval, void *value))
MPI_DECLARE(Comm_get_attr, (MPI_Comm comm, int keyval, void *value, int *flag))
MPI_DECLARE(Comm_delete_attr, (MPI_Comm comm, int keyval))
MPI_DECLARE(Type_create_keyval, (MPI_Type_copy_attr_function * copy, MPI_Type_delete_attr_function *drop,
                                 int *keyval, void *extra))
MPI_DECLARE(Type_free_keyval, (int *keyval))
MPI_DECLARE(Type_set_attr, (MPI_Datatype type, int keyval, void *value))
MPI_DECLARE(Type_get_attr, (MPI_Datatype type, int keyval, void *value, int *flag))
MPI_DECLARE(Type_delete_attr, (MPI_Datatype type, int keyval))

/* errors */
MPI_DECLARE(Comm_create_errhandler, (MPI_Comm_errhandler_function * function, MPI_Errhandler *handler))
MPI_DECLARE(Comm_set_errhandler, (MPI_Comm comm, MPI_Errhandler handler))
MPI_DECLARE(Comm_get_errhandler, (MPI_Comm comm, MPI_Errhandler *handler))
MPI_DECLARE(Comm_call_errhandler, (MPI_Comm comm, int code))
MPI_DECLARE(Errhandler_free, (MPI_Errhandler * handler))
MPI_DECLARE(Error_string, (int code, char *text, int *length))
MPI_DECLARE(Error_class, (int code, int *kind))
MPI_DECLARE(Add_error_class, (int *kind))
MPI_DECLARE(Add_error_code, (int kind, int *code))
MPI_DECLARE(Add_error_string, (int code, const char *text))

/* topologies */
MPI_DECLARE(Dims_create, (int nodes, int dims, int sides[]))
MPI_DECLARE(Cart_create,
            (MPI_Comm comm, int dims, const int sides[], const int periods[], int reorder, MPI_Comm *to))
MPI_DECLARE(Cart_coords, (MPI_Comm comm, int rank, int most, int coords[]))
MPI_DECLARE(Cart_rank, (MPI_Comm comm, const int coords[], int *rank))
MPI_DECLARE(Cart_shift, (MPI_Comm comm, int direction, int by, int *source, int *dest))
MPI_DECLARE(Cart_sub, (MPI_Comm comm, const int keep[], MPI_Comm *to))
MPI_DECLARE(Cart_get, (MPI_Comm comm, int most, int sides[], int periods[], int coords[]))
MPI_DECLARE(Cartdim_get, (MPI_Comm comm, int *dims))
MPI_DECLARE(Cart_map, (MPI_Comm comm, int dims, const int sides[], const int periods[], int *rank))
MPI_DECLARE(Graph_create,
            (MPI_Comm comm, int nodes, const int ends[], const int edges[], int reorder, MPI_Comm *to))
MPI_DECLARE(Graph_get, (MPI_Comm comm, int most_nodes, int most_edges, int ends[], int edges[]))
MPI_DECLARE(Graphdims_get, (MPI_Comm comm, int *nodes, int *edges))
MPI_DECLARE(Graph_neighbors_count, (MPI_Comm comm, int rank, int *count))
MPI_DECLARE(Graph_neighbors, (MPI_Comm comm, int rank, int most, int neighbors[]))
MPI_DECLARE(Graph_map, (MPI_Comm comm, int nodes, const int ends[], const int edges[], int *rank))
MPI_DECLARE(Topo_test, (MPI_Comm comm, int *kind))

MPI_DECLARE(Dist_graph_create_adjacent,
            (MPI_Comm comm, int ins, const int sources[], const int *in_weights, int outs, const int dests[],
             const int *out_weights, MPI_Info info, int reorder, MPI_Comm *to))
MPI_DECLARE(Dist_graph_create,
            (MPI_Comm comm, int count, const int sources[], const int degrees[], const int dests[],
             const int *weights, MPI_Info info, int reorder, MPI_Comm *to))
MPI_DECLARE(Dist_graph_neighbors_count, (MPI_Comm comm, int *ins, int *outs, int *weighted))
MPI_DECLARE(Dist_graph_neighbors, (MPI_Comm comm, int most_ins, int sources[], int *in_weights, int most_outs,
                                   int dests[], int *out_weights))
#define NEIGHBOR(name, parameters)                                                                           \
    MPI_DECLARE(Neighbor_##name, (NEIGHBOR_LIST parameters, MPI_Comm comm))                                  \
    MPI_DECLARE(Ineighbor_##name, (NEIGHBOR_LIST parameters, MPI_Comm comm, MPI_Request * request))
#define NEIGHBOR_LIST(...) __VA_ARGS__
NEIGHBOR(allgather, (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as))
NEIGHBOR(allgatherv, (const void *buf, int count, MPI_Datatype type, void *into, const int rooms[],
                      const int places[], MPI_Datatype as))
NEIGHBOR(alltoall, (const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as))
NEIGHBOR(alltoallv, (const void *buf, const int counts[], const int at[], MPI_Datatype type, void *into,
                     const int rooms[], const int places[], MPI_Datatype as))
NEIGHBOR(alltoallw, (const void *buf, const int counts[], const MPI_Aint at[], const MPI_Datatype types[],
                     void *into, const int rooms[], const MPI_Aint places[], const MPI_Datatype as[]))
#undef NEIGHBOR
#undef NEIGHBOR_LIST

/* hints: kept, and without effect */
MPI_DECLARE(Info_create, (MPI_Info * info))
MPI_DECLARE(Info_set, (MPI_Info info, const char *key, const char *value))
MPI_DECLARE(Info_get, (MPI_Info info, const char *key, int room, char *value, int *flag))
MPI_DECLARE(Info_get_string, (MPI_Info info, const char *key, int *room, char *value, int *flag))
MPI_DECLARE(Info_create_env, (int argc, char *argv[], MPI_Info *info))
MPI_DECLARE(Info_get_valuelen, (MPI_Info info, const char *key, int *length, int *flag))
MPI_DECLARE(Info_get_nkeys, (MPI_Info info, int *count))
MPI_DECLARE(Info_get_nthkey, (MPI_Info info, int n, char *key))
MPI_DECLARE(Info_delete, (MPI_Info info, const char *key))
MPI_DECLARE(Info_dup, (MPI_Info info, MPI_Info *to))
MPI_DECLARE(Info_free, (MPI_Info * info))

/* files: places are counted in the etypes of the view */
MPI_DECLARE(File_open, (MPI_Comm comm, const char *name, int amode, MPI_Info info, MPI_File *file))
MPI_DECLARE(File_close, (MPI_File * file))
MPI_DECLARE(File_delete, (const char *name, MPI_Info info))
MPI_DECLARE(File_set_size, (MPI_File file, MPI_Offset bytes))
MPI_DECLARE(File_preallocate, (MPI_File file, MPI_Offset bytes))
MPI_DECLARE(File_get_size, (MPI_File file, MPI_Offset *bytes))
MPI_DECLARE(File_get_group, (MPI_File file, MPI_Group *group))
MPI_DECLARE(File_get_amode, (MPI_File file, int *amode))
MPI_DECLARE(File_set_info, (MPI_File file, MPI_Info info))
MPI_DECLARE(File_get_info, (MPI_File file, MPI_Info *info))
MPI_DECLARE(File_set_view, (MPI_File file, MPI_Offset displacement, MPI_Datatype etype, MPI_Datatype filetype,
                            const char *representation, MPI_Info info))
MPI_DECLARE(File_get_view, (MPI_File file, MPI_Offset *displacement, MPI_Datatype *etype,
                            MPI_Datatype *filetype, char *representation))
MPI_DECLARE(Register_datarep,
            (const char *name, MPI_Datarep_conversion_function *read, MPI_Datarep_conversion_function *write,
             MPI_Datarep_extent_function *extent, void *extra))
MPI_DECLARE(File_get_type_extent, (MPI_File file, MPI_Datatype type, MPI_Aint *extent))
MPI_DECLARE(File_seek, (MPI_File file, MPI_Offset place, int whence))
MPI_DECLARE(File_get_position, (MPI_File file, MPI_Offset *place))
MPI_DECLARE(File_seek_shared, (MPI_File file, MPI_Offset place, int whence))
MPI_DECLARE(File_get_position_shared, (MPI_File file, MPI_Offset *place))
MPI_DECLARE(File_get_byte_offset, (MPI_File file, MPI_Offset place, MPI_Offset *bytes))
MPI_DECLARE(File_set_atomicity, (MPI_File file, int flag))
MPI_DECLARE(File_get_atomicity, (MPI_File file, int *flag))
MPI_DECLARE(File_sync, (MPI_File file))
MPI_DECLARE(File_create_errhandler, (MPI_File_errhandler_function * function, MPI_Errhandler *handler))
MPI_DECLARE(File_set_errhandler, (MPI_File file, MPI_Errhandler handler))
MPI_DECLARE(File_get_errhandler, (MPI_File file, MPI_Errhandler *handler))
MPI_DECLARE(File_call_errhandler, (MPI_File file, int code))
#define MOVE(name, buffer, ...)                                                                              \
    MPI_DECLARE(File_##name,                                                                                 \
                (MPI_File file, __VA_ARGS__ buffer buf, int count, MPI_Datatype type, MPI_Status *status))
#define MOVE_LATER(name, buffer, ...)                                                                        \
    MOVE(name, buffer, __VA_ARGS__)                                                                          \
    MPI_DECLARE(File_i##name,                                                                                \
                (MPI_File file, __VA_ARGS__ buffer buf, int count, MPI_Datatype type, MPI_Request *request))
#define MOVE_IN_TWO_CALLS(name, buffer, ...)                                                                 \
    MPI_DECLARE(File_##name##_begin, (MPI_File file, __VA_ARGS__ buffer buf, int count, MPI_Datatype type))  \
    MPI_DECLARE(File_##name##_end, (MPI_File file, buffer buf, MPI_Status * status))
#define PLACE MPI_Offset place,
#define MOVES(name, buffer)                                                                                  \
    MOVE_LATER(name, buffer, )                                                                               \
    MOVE_LATER(name##_all, buffer, )                                                                         \
    MOVE_LATER(name##_at, buffer, PLACE)                                                                     \
    MOVE_LATER(name##_at_all, buffer, PLACE)                                                                 \
    MOVE_LATER(name##_shared, buffer, )                                                                      \
    MOVE(name##_ordered, buffer, )                                                                           \
    MOVE_IN_TWO_CALLS(name##_all, buffer, )                                                                  \
    MOVE_IN_TWO_CALLS(name##_at_all, buffer, PLACE)                                                          \
    MOVE_IN_TWO_CALLS(name##_ordered, buffer, )
MOVES(read, void *)
MOVES(write, const void *)
#undef MOVE
#undef MOVE_LATER
#undef MOVE_IN_TWO_CALLS
#undef PLACE
#undef MOVES

/* windows: memory that other ranks of a communicator read and write */
MPI_DECLARE(Win_create, (void *base, MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, MPI_Win *win))
MPI_DECLARE(Win_allocate, (MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, void *base, MPI_Win *win))
MPI_DECLARE(Win_allocate_shared,
            (MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, void *base, MPI_Win *win))
MPI_DECLARE(Win_shared_query, (MPI_Win win, int rank, MPI_Aint *size, int *unit, void *base))
MPI_DECLARE(Win_create_dynamic, (MPI_Info info, MPI_Comm comm, MPI_Win *win))
MPI_DECLARE(Win_attach, (MPI_Win win, void *base, MPI_Aint size))
MPI_DECLARE(Win_detach, (MPI_Win win, const void *base))
MPI_DECLARE(Win_free, (MPI_Win * win))
MPI_DECLARE(Win_get_group, (MPI_Win win, MPI_Group *group))
MPI_DECLARE(Win_set_name, (MPI_Win win, const char *name))
MPI_DECLARE(Win_get_name, (MPI_Win win, char *name, int *length))
MPI_DECLARE(Win_set_info, (MPI_Win win, MPI_Info info))
MPI_DECLARE(Win_get_info, (MPI_Win win, MPI_Info *info))
MPI_DECLARE(Win_create_keyval,
            (MPI_Win_copy_attr_function * copy, MPI_Win_delete_attr_function *drop, int *keyval, void *extra))
MPI_DECLARE(Win_free_keyval, (int *keyval))
MPI_DECLARE(Win_set_attr, (MPI_Win win, int keyval, void *value))
MPI_DECLARE(Win_get_attr, (MPI_Win win, int keyval, void *value, int *flag))
MPI_DECLARE(Win_delete_attr, (MPI_Win win, int keyval))
MPI_DECLARE(Win_create_errhandler, (MPI_Win_errhandler_function * function, MPI_Errhandler *handler))
MPI_DECLARE(Win_set_errhandler, (MPI_Win win, MPI_Errhandler handler))
MPI_DECLARE(Win_get_errhandler, (MPI_Win win, MPI_Errhandler *handler))
MPI_DECLARE(Win_call_errhandler, (MPI_Win win, int code))
MPI_DECLARE(Win_fence, (int assert, MPI_Win win))
MPI_DECLARE(Win_start, (MPI_Group group, int assert, MPI_Win win))
MPI_DECLARE(Win_complete, (MPI_Win win))
MPI_DECLARE(Win_post, (MPI_Group group, int assert, MPI_Win win))
MPI_DECLARE(Win_wait, (MPI_Win win))
MPI_DECLARE(Win_test, (MPI_Win win, int *flag))
MPI_DECLARE(Win_lock, (int kind, int rank, int assert, MPI_Win win))
MPI_DECLARE(Win_unlock, (int rank, MPI_Win win))
MPI_DECLARE(Win_lock_all, (int assert, MPI_Win win))
MPI_DECLARE(Win_unlock_all, (MPI_Win win))
MPI_DECLARE(Win_flush, (int rank, MPI_Win win))
MPI_DECLARE(Win_flush_all, (MPI_Win win))
MPI_DECLARE(Win_flush_local, (int rank, MPI_Win win))
MPI_DECLARE(Win_flush_local_all, (MPI_Win win))
MPI_DECLARE(Win_sync, (MPI_Win win))
#define HERE const void *buf, int count, MPI_Datatype type
#define INTO void *into, int room, MPI_Datatype as
#define THERE int rank, MPI_Aint place, int their_count, MPI_Datatype their_type
MPI_DECLARE(Put, (HERE, THERE, MPI_Win win))
MPI_DECLARE(Get, (INTO, THERE, MPI_Win win))
MPI_DECLARE(Accumulate, (HERE, THERE, MPI_Op op, MPI_Win win))
MPI_DECLARE(Get_accumulate, (HERE, INTO, THERE, MPI_Op op, MPI_Win win))
MPI_DECLARE(Rput, (HERE, THERE, MPI_Win win, MPI_Request *request))
MPI_DECLARE(Rget, (INTO, THERE, MPI_Win win, MPI_Request *request))
MPI_DECLARE(Raccumulate, (HERE, THERE, MPI_Op op, MPI_Win win, MPI_Request *request))
MPI_DECLARE(Rget_accumulate, (HERE, INTO, THERE, MPI_Op op, MPI_Win win, MPI_Request *request))
#undef HERE
#undef INTO
#undef THERE
MPI_DECLARE(Fetch_and_op, (const void *buf, void *into, MPI_Datatype type, int rank, MPI_Aint place,
                           MPI_Op op, MPI_Win win))
MPI_DECLARE(Compare_and_swap, (const void *buf, const void *compare, void *into, MPI_Datatype type, int rank,
                               MPI_Aint place, MPI_Win win))
