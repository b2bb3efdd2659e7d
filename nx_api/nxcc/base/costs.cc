/* costs.cc - see costs.h. The files of machines/cpu explain the cost classes. */
#include "base/gcc.h"
#include "base/costs.h"
#include <fnmatch.h>
#include <math.h>
#include <string.h>
#include <map>

namespace
{
cost_table table;
std::vector<cost_factor> factors;

bool is_single(tree type)
{
    return TYPE_PRECISION(type) <= 32;
}

/* The type of one element of a vector or complex number; any other type is its own. */
tree scalar_type(tree type)
{
    return VECTOR_TYPE_P(type) || TREE_CODE(type) == COMPLEX_TYPE ? TREE_TYPE(type) : type;
}

bool is_float(tree type)
{
    return SCALAR_FLOAT_TYPE_P(scalar_type(type));
}

/* An i860 instruction holds a constant of 16 bits; a longer one takes an instruction more. */
int64_t constant_cost(tree operand)
{
    if (!operand || TREE_CODE(operand) != INTEGER_CST || !tree_fits_shwi_p(operand))
        return 0;
    HOST_WIDE_INT v = tree_to_shwi(operand);
    return v < -32768 || v > 65535 ? table.clocks.large_constant : 0;
}

bool is_power_of_two(tree operand)
{
    return TREE_CODE(operand) == INTEGER_CST && tree_fits_shwi_p(operand) && tree_to_shwi(operand) > 0 &&
           pow2p_hwi(tree_to_shwi(operand));
}

/* The cost of computing an address, as far as it does not fold into the load or store. */
int64_t address_cost(tree ref)
{
    int64_t cost = 0;
    for (; handled_component_p(ref); ref = TREE_OPERAND(ref, 0)) {
        if (TREE_CODE(ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(ref, 1)))
            cost += table.clocks.bitfield;
        if (TREE_CODE(ref) == BIT_FIELD_REF)
            cost += table.clocks.bitfield;
        if ((TREE_CODE(ref) == ARRAY_REF || TREE_CODE(ref) == ARRAY_RANGE_REF) &&
            TREE_CODE(TREE_OPERAND(ref, 1)) != INTEGER_CST)
            cost += table.clocks.index;
    }
    return cost;
}

bool is_memory(tree operand)
{
    if (!operand || is_gimple_reg(operand))
        return false;
    tree base = handled_component_p(operand) ? get_base_address(operand) : operand;
    if (!base)
        return false;
    if (DECL_P(base))
        return TREE_CODE(base) != FUNCTION_DECL && TREE_CODE(base) != LABEL_DECL;
    return TREE_CODE(base) == MEM_REF || TREE_CODE(base) == TARGET_MEM_REF;
}

/* 8-byte words moved by a copy of this type: 1 for any scalar. */
int64_t words(tree type)
{
    if (!(AGGREGATE_TYPE_P(type) || VECTOR_TYPE_P(type)) || !TYPE_SIZE_UNIT(type) ||
        !tree_fits_uhwi_p(TYPE_SIZE_UNIT(type)))
        return 1;
    return (int64_t)((tree_to_uhwi(TYPE_SIZE_UNIT(type)) + 7) / 8);
}

/* The cost of a static variable's address of 32 bits, of which a load or store holds 16. In a loop, GCC keeps
 * such addresses in registers, and the accesses that it leaves do not name the variable. */
int64_t base_cost(tree operand)
{
    tree base = get_base_address(operand);
    return base && VAR_P(base) && (TREE_STATIC(base) || DECL_EXTERNAL(base)) ? table.clocks.static_address
                                                                             : 0;
}

int64_t memory_cost(tree operand, int64_t access)
{
    if (!is_memory(operand))
        return 0;
    return base_cost(operand) + address_cost(operand) + access * words(TREE_TYPE(operand));
}

int64_t divide_cost(tree divisor)
{
    /* by a power of two: a shift, and the correction for negative numbers */
    return is_power_of_two(divisor) ? 3 * table.clocks.integer : table.clocks.divide;
}

int64_t float_cost(tree_code code, tree type)
{
    bool single = is_single(scalar_type(type));
    switch (code) {
    case MULT_EXPR:
        return single ? table.clocks.fp_multiply_single : table.clocks.fp_multiply_double;
    case RDIV_EXPR:
        return single ? table.clocks.fp_divide_single : table.clocks.fp_divide_double;
    case ABS_EXPR:
    case NEGATE_EXPR:
    case PAREN_EXPR:
        return code == PAREN_EXPR ? 0 : table.clocks.fp_move;
    case MIN_EXPR:
    case MAX_EXPR:
        return table.clocks.fp_compare + table.clocks.branch;
    default:
        return single ? table.clocks.fp_add_single : table.clocks.fp_add_double;
    }
}

int64_t integer_cost(tree_code code, gassign *stmt)
{
    tree second = gimple_num_ops(stmt) > 2 ? gimple_assign_rhs2(stmt) : NULL_TREE;
    switch (code) {
    case MULT_EXPR:
    case MULT_HIGHPART_EXPR:
    case WIDEN_MULT_EXPR:
        return is_power_of_two(second) ? table.clocks.integer : table.clocks.multiply;
    case TRUNC_DIV_EXPR:
    case CEIL_DIV_EXPR:
    case FLOOR_DIV_EXPR:
    case ROUND_DIV_EXPR:
    case EXACT_DIV_EXPR:
    case TRUNC_MOD_EXPR:
    case CEIL_MOD_EXPR:
    case FLOOR_MOD_EXPR:
    case ROUND_MOD_EXPR:
        return divide_cost(second);
    case MIN_EXPR:
    case MAX_EXPR:
    case ABS_EXPR:
        return table.clocks.integer + table.clocks.branch;
    default:
        return table.clocks.integer + constant_cost(second);
    }
}

int64_t conversion_cost(tree_code code, tree to, tree from)
{
    if (code == FLOAT_EXPR || code == FIX_TRUNC_EXPR)
        return table.clocks.convert_integer;
    if (is_float(to) && is_float(from))
        return is_single(scalar_type(to)) == is_single(scalar_type(from)) ? 0
                                                                          : table.clocks.convert_precision;
    return 0; /* between integers and pointers: a register keeps its bits, short loads extend */
}

int64_t compare_cost(tree operand)
{
    return is_float(TREE_TYPE(operand)) ? table.clocks.fp_compare : table.clocks.integer;
}

/* The elements of a vector, which the simulated processors compute one by one; 1 for any other type. */
int64_t lanes(tree type)
{
    return VECTOR_TYPE_P(type) ? (int64_t)TYPE_VECTOR_SUBPARTS(type).to_constant() : 1;
}

/* The cost of the operation of an assignment, or of one element of a vector, without loads and store. */
int64_t operation_cost(gassign *stmt)
{
    tree_code code = gimple_assign_rhs_code(stmt);
    tree first = gimple_assign_rhs1(stmt);
    tree type = TREE_TYPE(gimple_assign_lhs(stmt));
    if (gimple_assign_single_p(stmt)) /* copy, constant, load, address */
        return code == ADDR_EXPR ? table.clocks.integer + address_cost(TREE_OPERAND(first, 0)) : 0;
    if (CONVERT_EXPR_CODE_P(code) || code == FLOAT_EXPR || code == FIX_TRUNC_EXPR)
        return conversion_cost(code, type, TREE_TYPE(first));
    if (code == VIEW_CONVERT_EXPR || code == COMPLEX_EXPR || code == REALPART_EXPR || code == IMAGPART_EXPR)
        return 0;
    if (TREE_CODE_CLASS(code) == tcc_comparison)
        return compare_cost(first) + constant_cost(gimple_assign_rhs2(stmt));
    if (code == COND_EXPR)
        return table.clocks.branch + (COMPARISON_CLASS_P(first) ? compare_cost(TREE_OPERAND(first, 0)) : 0);
    return is_float(type) ? float_cost(code, type) : integer_cost(code, stmt);
}

/* A block that no i860's data cache has costs as much, moved by an assignment, as by memcpy or memset: GCC
 * makes such assignments of their calls. 0: it is none. */
int64_t moved_block_cost(gassign *stmt)
{
    const int64_t largest_cache = 16384;
    tree to = gimple_assign_lhs(stmt), from = gimple_assign_rhs1(stmt);
    int64_t bytes = 8 * words(TREE_TYPE(to));
    if (2 * bytes <= largest_cache || !gimple_assign_single_p(stmt))
        return 0;
    auto price = table.calls.find(is_memory(from) ? "memcpy" : "memset");
    return price == table.calls.end() ? 0 : price->second.base + bytes * price->second.far;
}

int64_t assign_cost(gassign *stmt)
{
    if (gimple_clobber_p(stmt))
        return 0;
    if (int64_t block = moved_block_cost(stmt))
        return block;
    int64_t cost = lanes(TREE_TYPE(gimple_assign_lhs(stmt))) * operation_cost(stmt) +
                   memory_cost(gimple_assign_lhs(stmt), table.clocks.store);
    if (gimple_assign_single_p(stmt)) {
        cost += memory_cost(gimple_assign_rhs1(stmt), table.clocks.load);
        if (is_memory(gimple_assign_lhs(stmt)))
            cost += constant_cost(gimple_assign_rhs1(stmt));
    }
    return cost;
}

/* --- calls ---------------------------------------------------------------------------------------------- */

/* The name of the library function that is called, or NULL if the callee is code of the program. */
const char *library_name(gcall *call)
{
    tree decl = gimple_call_fndecl(call);
    if (!decl || !(DECL_EXTERNAL(decl) || fndecl_built_in_p(decl)) || DECL_STRUCT_FUNCTION(decl))
        return NULL;
    const char *name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(decl));
    name += *name == '*';
    return strncmp(name, "__builtin_", 10) ? name : name + 10;
}

/* The entry of the cost table for a function: of its name, else of the longest pattern that fits the name.
 * NULL: none. */
const call_cost *find_listed(const char *name)
{
    auto exact = table.calls.find(name);
    if (exact != table.calls.end())
        return &exact->second;
    const std::pair<const std::string, call_cost> *longest = NULL;
    for (const auto &entry : table.calls)
        if ((!longest || entry.first.size() > longest->first.size()) &&
            !fnmatch(entry.first.c_str(), name, 0))
            longest = &entry;
    return longest ? &longest->second : NULL;
}

/* The entry of the cost table for a call, or NULL. */
const call_cost *listed(gcall *call)
{
    static std::map<std::string, const call_cost *> found; /* what find_listed has answered */
    const char *name = library_name(call);
    if (!name)
        return NULL;
    auto before = found.find(name);
    return before != found.end() ? before->second : found[name] = find_listed(name);
}

/* Can a price count the elements of an array behind a pointer to `to`? A descriptor is a record, and GCC may
 * have lost its type. */
bool may_be_descriptor(tree to)
{
    to = TREE_CODE(to) == ARRAY_TYPE ? TREE_TYPE(to) : to;
    return !INTEGRAL_TYPE_P(to) && !SCALAR_FLOAT_TYPE_P(to) && TREE_CODE(to) != COMPLEX_TYPE;
}

/* What is wrong with a price whose function has these types; "": nothing. types: the result's, then the
 * arguments'. */
std::string misfit(const call_cost &price, const std::vector<tree> &types)
{
    for (int i : price.of) {
        std::string argument = i ? "argument " + std::to_string(i) : "result";
        if (i >= (int)types.size())
            return "the function has no " + argument;
        tree type = types[i];
        if (price.kind == PRICED_INTEGERS ? !INTEGRAL_TYPE_P(type) || TREE_CODE(type) == BOOLEAN_TYPE
                                          : !POINTER_TYPE_P(type) || !may_be_descriptor(TREE_TYPE(type)))
            return "the function's " + argument + " is no " +
                   (price.kind == PRICED_INTEGERS ? "integer" : "array");
    }
    return "";
}

void refuse(const call_cost &price, const char *name, const std::string &why)
{
    fprintf(stderr, "nxcc: %s: calls: '%s': %s\n", price.where.c_str(), name, why.c_str());
    exit(FATAL_EXIT_CODE);
}

/* The cost of a library function that GCC calls by a name of its own, as floorf by .FLOOR; -1: it is none. */
int64_t library_cost(gcall *call)
{
    tree type = gimple_call_lhs(call) ? TREE_TYPE(gimple_call_lhs(call)) : NULL_TREE;
    tree function = type ? mathfn_built_in(type, gimple_call_combined_fn(call)) : NULL_TREE;
    if (!function)
        return -1;
    const call_cost *known = find_listed(IDENTIFIER_POINTER(DECL_NAME(function)) + strlen("__builtin_"));
    return known ? known->base : table.clocks.call + gimple_call_num_args(call) * table.clocks.argument;
}

/* The cost of a function of GCC's own, which stands for one or a few operations of the program. */
int64_t internal_cost(gcall *call)
{
    tree lhs = gimple_call_lhs(call);
    switch (gimple_call_internal_fn(call)) {
    case IFN_FMS:
    case IFN_FNMA:
    case IFN_FNMS:
        return float_cost(MULT_EXPR, TREE_TYPE(lhs)) + float_cost(PLUS_EXPR, TREE_TYPE(lhs));
    case IFN_XORSIGN:
        return table.clocks.fp_move + float_cost(MULT_EXPR, TREE_TYPE(lhs));
    case IFN_SIGNBIT:
    case IFN_ADD_OVERFLOW: /* and a comparison */
    case IFN_SUB_OVERFLOW:
    case IFN_UBSAN_CHECK_ADD:
    case IFN_UBSAN_CHECK_SUB:
        return 2 * table.clocks.integer;
    case IFN_MUL_OVERFLOW:
    case IFN_UBSAN_CHECK_MUL:
        return table.clocks.multiply + table.clocks.integer;
    case IFN_MULH:
        return table.clocks.multiply;
    case IFN_DIVMOD: /* the remainder is what the quotient's product leaves */
        return table.clocks.divide + table.clocks.multiply + table.clocks.integer;
    case IFN_CLRSB: /* the i860 counts bits in a procedure */
    case IFN_CLZ:
    case IFN_CTZ:
    case IFN_FFS:
    case IFN_PARITY:
    case IFN_POPCOUNT:
        return table.clocks.call + table.clocks.argument;
    case IFN_VCOND: /* a comparison and a choice for each element */
    case IFN_VCONDU:
    case IFN_VCONDEQ:
        return lanes(TREE_TYPE(lhs)) * (compare_cost(gimple_call_arg(call, 0)) + table.clocks.branch);
    case IFN_VCOND_MASK:
        return lanes(TREE_TYPE(lhs)) * table.clocks.branch;
    case IFN_VEC_SET: /* of one element, whose place varies */
        return table.clocks.index + table.clocks.integer;
    case IFN_SPACESHIP: /* less, equal or greater? Branches on that follow. */
        return 2 * table.clocks.fp_compare;
    case IFN_ATOMIC_BIT_TEST_AND_SET:
    case IFN_ATOMIC_BIT_TEST_AND_COMPLEMENT:
    case IFN_ATOMIC_BIT_TEST_AND_RESET:
    case IFN_ATOMIC_COMPARE_EXCHANGE:
    case IFN_ATOMIC_ADD_FETCH_CMP_0:
    case IFN_ATOMIC_SUB_FETCH_CMP_0:
    case IFN_ATOMIC_AND_FETCH_CMP_0:
    case IFN_ATOMIC_OR_FETCH_CMP_0:
    case IFN_ATOMIC_XOR_FETCH_CMP_0:
        return table.clocks.load + 2 * table.clocks.integer + table.clocks.store;
    case IFN_ABNORMAL_DISPATCHER: /* no operations */
    case IFN_ANNOTATE:
    case IFN_BUILTIN_EXPECT:
    case IFN_DEFERRED_INIT:
    case IFN_FALLTHROUGH:
    case IFN_LAUNDER:
    case IFN_NOP:
    case IFN_PHI:
    case IFN_UNIQUE:
        return 0;
    default:
        break;
    }
    int64_t library = library_cost(call);
    if (library < 0)
        fatal_error(gimple_location(call),
                    "nxcc has no cost for GCC%'s %qs: compile the file with %<-O1%>, and report it",
                    internal_fn_name(gimple_call_internal_fn(call)));
    return library;
}

/* The cost of a call that GCC expands in place to a few instructions; -1 for all others. */
int64_t expanded_cost(gcall *call)
{
    tree lhs = gimple_call_lhs(call);
    bool single = lhs && is_float(TREE_TYPE(lhs)) && is_single(scalar_type(TREE_TYPE(lhs)));
    switch (gimple_call_combined_fn(call)) {
    case CFN_SQRT:
    case CFN_BUILT_IN_SQRT:
    case CFN_BUILT_IN_SQRTF:
        return single ? table.clocks.fp_sqrt_single : table.clocks.fp_sqrt_double;
    case CFN_BUILT_IN_FABS:
    case CFN_BUILT_IN_FABSF:
    case CFN_COPYSIGN:
    case CFN_BUILT_IN_COPYSIGN:
    case CFN_BUILT_IN_COPYSIGNF:
        return table.clocks.fp_move;
    case CFN_FMA:
        return float_cost(MULT_EXPR, TREE_TYPE(lhs)) + float_cost(PLUS_EXPR, TREE_TYPE(lhs));
    case CFN_BUILT_IN_EXPECT:
    case CFN_BUILT_IN_UNREACHABLE:
    case CFN_BUILT_IN_ASSUME_ALIGNED:
    case CFN_BUILT_IN_PREFETCH:
    case CFN_BUILT_IN_STACK_SAVE:
    case CFN_BUILT_IN_STACK_RESTORE:
    case CFN_BUILT_IN_FRAME_ADDRESS:
    case CFN_BUILT_IN_RETURN_ADDRESS:
    case CFN_BUILT_IN_TRAP:
        return 0;
    case CFN_BUILT_IN_ALLOCA:
    case CFN_BUILT_IN_ALLOCA_WITH_ALIGN:
    case CFN_BUILT_IN_VA_START:
    case CFN_BUILT_IN_VA_END:
    case CFN_BUILT_IN_VA_COPY:
    case CFN_BUILT_IN_ISNAN:
    case CFN_BUILT_IN_SIGNBIT:
        return 2 * table.clocks.integer;
    default:
        return gimple_call_internal_p(call) ? internal_cost(call) : -1;
    }
}

int64_t argument_loads(gcall *call)
{
    int64_t cost = 0;
    for (unsigned i = 0; i < gimple_call_num_args(call); i++)
        cost += memory_cost(gimple_call_arg(call, i), table.clocks.load);
    return cost;
}

/* Is it a call of sqrt that GCC expands in place, since errno is not wanted? */
bool is_root_in_place(gcall *call)
{
    return !gimple_call_internal_p(call) && replacement_internal_fn(call) == IFN_SQRT;
}

int64_t fixed_call_cost(gcall *call)
{
    int64_t cost = argument_loads(call) + memory_cost(gimple_call_lhs(call), table.clocks.store);
    const call_cost *known = is_root_in_place(call) ? NULL : listed(call);
    if (known)
        return cost + known->base;
    int64_t expanded = expanded_cost(call);
    if (expanded >= 0)
        return cost + expanded;
    return cost + table.clocks.call + gimple_call_num_args(call) * table.clocks.argument;
}

/* Functions of the C library without output, allocation, call back or clock. Functions that the simulator
 * serves, and stdio, whose streams it serves, are not among them. */
bool is_uncounted_name(const char *name)
{
    static const char names[] =
        " memcpy memmove memset memcmp memchr strlen strnlen strcpy strncpy strcat strncat strcmp strncmp"
        " stpcpy stpncpy mempcpy strcasecmp strncasecmp strchr strrchr strstr strspn strcspn strpbrk strtok_r"
        " strtol strtoul strtoll strtoull strtod strtof atoi atol atof abs labs rand_r strerror"
        " __ctype_b_loc __ctype_tolower_loc __ctype_toupper_loc __errno_location toupper tolower"
        " isalpha isdigit isspace isalnum isupper islower isprint ispunct"
        " sqrt sqrtf cbrt cbrtf exp expf log logf log2 log10 pow powf sin sinf cos cosf tan asin acos atan "
        "atan2"
        " sinh cosh tanh floor floorf ceil ceilf fabs fabsf fmod fmin fmax fminf fmaxf hypot ldexp frexp modf"
        " rint round lround trunc sincos copysign"
        " tanf asinf acosf atanf atan2f sinhf coshf tanhf log10f fmodf rintf roundf lroundf truncf hypotf"
        " copysignf erf erff erfc erfcf tgamma tgammaf cabs cabsf cexp cexpf clog clogf csqrt csqrtf csin"
        " csinf ccos ccosf cpow cpowf _gfortran_pow_i4_i4 _gfortran_pow_r8_i8 _gfortran_pow_c4_i4"
        " _gfortran_pow_c8_i4"
        " _gfortran_compare_string _gfortran_string_len_trim _gfortran_string_index nx_elements ";
    const char *p = strstr(names, name);
    size_t n = strlen(name);
    for (; p; p = strstr(p + 1, name))
        if (p[-1] == ' ' && (p[n] == ' ' || p[n] == '\0'))
            return true;
    return false;
}

/* A program may have its own round() or log2(), which no system header declares. */
bool is_declared_by_library(tree decl)
{
    location_t where = DECL_SOURCE_LOCATION(decl);
    return where <= BUILTINS_LOCATION || in_system_header_at(where);
}

/* Does the call reach the library's function as the library declares it? GNU Fortran's library has no
 * header. */
bool is_library_function(gcall *call)
{
    return !strncmp(library_name(call), "_gfortran_", 10) || is_declared_by_library(gimple_call_fndecl(call));
}

/* Is it a call such as of __builtin_ctz, which GCC expands to an operation? */
bool is_operation(gcall *call)
{
    const char *name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(gimple_call_fndecl(call)));
    return !strncmp(name, "__builtin_", 10) && (gimple_call_flags(call) & (ECF_CONST | ECF_PURE));
}

/* --- cost factors --------------------------------------------------------------------------------------- */

/* The function in whose source a statement is written. */
tree written_in(gimple *stmt)
{
    for (tree b = gimple_block(stmt); b && TREE_CODE(b) == BLOCK; b = BLOCK_SUPERCONTEXT(b)) {
        if (!inlined_function_outer_scope_p(b))
            continue;
        tree origin = BLOCK_ABSTRACT_ORIGIN(b);
        if (origin && TREE_CODE(origin) == FUNCTION_DECL)
            return origin;
    }
    return current_function_decl;
}

/* "slice.c" names app/slice.c; "app/slice.c" does too; "lice.c" does not. */
bool file_matches(const std::string &wanted, const char *file)
{
    if (wanted.empty())
        return true;
    size_t n = file ? strlen(file) : 0;
    if (n < wanted.size() || wanted != file + (n - wanted.size()))
        return false;
    return n == wanted.size() || file[n - wanted.size() - 1] == '/';
}

double factor_of(tree function)
{
    const char *name = DECL_NAME(function) ? IDENTIFIER_POINTER(DECL_NAME(function)) : "";
    double factor = 1;
    for (const cost_factor &f : factors)
        if (file_matches(f.file, DECL_SOURCE_FILE(function)) && (f.function.empty() || f.function == name))
            factor *= f.factor;
    return factor;
}

int64_t with_factor(gimple *stmt, int64_t cost)
{
    return factors.empty() || !cost ? cost : llround((double)cost * factor_of(written_in(stmt)));
}

int64_t plain_cost(gimple *stmt)
{
    switch (gimple_code(stmt)) {
    case GIMPLE_ASSIGN:
        return assign_cost(as_a<gassign *>(stmt));
    case GIMPLE_CALL:
        return fixed_call_cost(as_a<gcall *>(stmt));
    case GIMPLE_COND:
        return compare_cost(gimple_cond_lhs(stmt)) + constant_cost(gimple_cond_rhs(stmt)) +
               table.clocks.branch;
    case GIMPLE_SWITCH:
        return table.clocks.jump_table;
    case GIMPLE_GOTO:
        return table.clocks.branch;
    case GIMPLE_ASM:
        return table.clocks.integer;
    default:
        return 0; /* labels, debug statements, predictions; a return is part of `call` */
    }
}
} // namespace

void costs_use(const cost_table &t, const std::vector<cost_factor> &f)
{
    table = t;
    factors = f;
}

bool costs_is_memory(tree operand)
{
    return is_memory(operand);
}

tree costs_written_in(gimple *stmt)
{
    return written_in(stmt);
}

const char *costs_priced_call(gimple *stmt)
{
    gcall *call = dyn_cast<gcall *>(stmt);
    return call && listed(call) ? library_name(call) : NULL;
}

int64_t costs_of(gimple *stmt)
{
    return with_factor(stmt, plain_cost(stmt));
}

int64_t costs_of_going_back(gimple *stmt)
{
    return with_factor(stmt, table.clocks.branch);
}

int64_t costs_of_call(gcall *call, const call_cost **price)
{
    const call_cost *known = listed(call);
    if (!known || !known->per)
        return 0;
    std::vector<tree> types = {gimple_call_return_type(call)};
    for (unsigned i = 0; i < gimple_call_num_args(call); i++)
        types.push_back(TREE_TYPE(gimple_call_arg(call, i)));
    std::string why = misfit(*known, types);
    if (!why.empty() && is_library_function(call))
        refuse(*known, library_name(call), why);
    *price = known;
    return why.empty() ? with_factor(call, known->per) : 0; /* the program declares the function otherwise */
}

void costs_check_built_in()
{
    for (int code = BUILT_IN_NONE + 1; code < END_BUILTINS; code++) {
        tree decl = builtin_decl_explicit((built_in_function)code);
        const char *name = decl ? IDENTIFIER_POINTER(DECL_NAME(decl)) : "";
        auto known = table.calls.find(strncmp(name, "__builtin_", 10) ? name : name + 10);
        if (known == table.calls.end())
            continue;
        std::vector<tree> types = {TREE_TYPE(TREE_TYPE(decl))};
        for (tree arg = TYPE_ARG_TYPES(TREE_TYPE(decl)); arg && arg != void_list_node; arg = TREE_CHAIN(arg))
            types.push_back(TREE_VALUE(arg));
        std::string why = misfit(known->second, types);
        if (!why.empty())
            refuse(known->second, known->first.c_str(), why);
    }
}

bool costs_call_is_uncounted(gcall *call)
{
    if (gimple_call_internal_p(call))
        return true;
    const char *name = library_name(call);
    if (!name)
        return false;
    return expanded_cost(call) >= 0 || is_operation(call) ||
           (is_uncounted_name(name) && is_declared_by_library(gimple_call_fndecl(call)));
}

void costs_warn_if_taken_for_library(tree function)
{
    if (TREE_PUBLIC(function) && DECL_NAME(function) &&
        is_uncounted_name(IDENTIFIER_POINTER(DECL_NAME(function))))
        warning_at(DECL_SOURCE_LOCATION(function), 0,
                   "nxcc: %qD has the name of a C library function: files that include the library%'s header "
                   "do not count it and must not be preempted in it; rename it or make it static",
                   function);
}
