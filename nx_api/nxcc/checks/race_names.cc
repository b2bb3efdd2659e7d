/* race_names.cc - see race_names.h. GCC has taken the source's expressions apart, and moved offsets into
 * pointers; this puts back together what it can. */
#include "checks/race_names.h"
#include "base/costs.h"
#include "langhooks.h"

namespace
{
const int deepest = 8; /* statements back that a pointer is followed */

/* A name as far as it is known: of an object, or of a pointer to the object. */
struct name {
    std::string text;
    bool is_pointer = false;
    tree type = NULL_TREE; /* of the object; NULL: not known */
    int64_t offset = 0;    /* bytes in the object that are still to be named */
};

name behind(tree pointer, int depth);

bool is_fortran()
{
    return lang_GNU_Fortran();
}

std::string index_text(const std::string &index)
{
    return is_fortran() ? "(...)" : "[" + index + "]";
}

std::string with_index(const std::string &text, const std::string &index)
{
    std::string one = index_text(index);
    bool has = text.size() >= one.size() && is_fortran() &&
               text.compare(text.size() - one.size(), one.size(), one) == 0;
    return text.empty() || has ? text : text + one;
}

/* The object itself, as a whole. */
std::string object_text(const name &n)
{
    return n.is_pointer && !n.text.empty() && !is_fortran() ? "*" + n.text : n.text;
}

/* GNU Fortran's descriptor of an array, whose fields the source does not name. */
bool is_in_descriptor(tree field)
{
    return is_fortran() && TYPE_LANG_FLAG_1(DECL_CONTEXT(field)); /* GFC_DESCRIPTOR_TYPE_P */
}

std::string with_field(const name &n, tree field)
{
    if (!DECL_NAME(field) || is_in_descriptor(field))
        return n.text;
    const char *join = n.text.empty() ? "" : is_fortran() ? "%" : n.is_pointer ? "->" : ".";
    return n.text + join + IDENTIFIER_POINTER(DECL_NAME(field));
}

int64_t bytes_of(tree type)
{
    tree size = type ? TYPE_SIZE_UNIT(type) : NULL_TREE;
    return size && tree_fits_shwi_p(size) ? tree_to_shwi(size) : -1;
}

/* The field of a record that holds so many bytes at offset, or NULL; of a union the first such. */
tree field_at(tree record, int64_t offset, int64_t bytes)
{
    for (tree f = TYPE_FIELDS(record); f; f = DECL_CHAIN(f)) {
        if (TREE_CODE(f) != FIELD_DECL || !tree_fits_shwi_p(byte_position(f)))
            continue;
        int64_t at = int_byte_position(f), size = bytes_of(TREE_TYPE(f));
        if (offset >= at && offset + bytes <= at + size)
            return f;
    }
    return NULL_TREE;
}

/* Goes into the object to what lies at an offset and has so many bytes. */
name inside(name n, int64_t offset, int64_t bytes)
{
    offset += n.offset;
    n.offset = 0;
    while (n.type && bytes >= 0 && (offset || bytes < bytes_of(n.type) || n.text.empty())) {
        if (RECORD_OR_UNION_TYPE_P(n.type)) {
            tree f = offset >= 0 ? field_at(n.type, offset, bytes) : NULL_TREE;
            if (!f)
                return n;
            offset -= int_byte_position(f);
            n = {with_field(n, f), false, TREE_TYPE(f)};
        } else if (TREE_CODE(n.type) == ARRAY_TYPE && bytes_of(TREE_TYPE(n.type)) > 0) {
            int64_t each = bytes_of(TREE_TYPE(n.type));
            n = {with_index(n.text, std::to_string(offset / each)), false, TREE_TYPE(n.type)};
            offset %= each;
        } else if (n.is_pointer && offset && bytes_of(n.type) > 0 && offset % bytes_of(n.type) == 0) {
            n = {with_index(n.text, std::to_string(offset / bytes_of(n.type))), false, n.type};
            offset = 0;
        } else {
            return n;
        }
    }
    return n;
}

/* GNU Fortran makes the parameter by which an array is given itself. */
const char *own_name(tree decl)
{
    bool given = decl && is_fortran() && TREE_CODE(decl) == PARM_DECL;
    return decl && DECL_NAME(decl) && (given || !DECL_ARTIFICIAL(decl)) ? IDENTIFIER_POINTER(DECL_NAME(decl))
                                                                        : NULL;
}

/* An index or an offset in bytes: its constant, or the variable of which it is a multiple. */
std::string index_name(tree index)
{
    for (int depth = 0; index && depth < deepest; depth++) {
        if (TREE_CODE(index) == INTEGER_CST)
            return depth ? "..." : std::to_string((int64_t)TREE_INT_CST_LOW(index));
        if (DECL_P(index))
            return own_name(index) ? own_name(index) : "...";
        if (TREE_CODE(index) != SSA_NAME)
            break;
        if (const char *own = own_name(SSA_NAME_VAR(index)))
            return own;
        gassign *def = dyn_cast<gassign *>(SSA_NAME_DEF_STMT(index));
        if (!def)
            break;
        tree_code code = gimple_assign_rhs_code(def);
        bool scaled =
            (code == MULT_EXPR || code == LSHIFT_EXPR) && TREE_CODE(gimple_assign_rhs2(def)) == INTEGER_CST;
        if (!scaled && !CONVERT_EXPR_CODE_P(code) && code != SSA_NAME && !DECL_P(gimple_assign_rhs1(def)))
            break;
        index = gimple_assign_rhs1(def);
    }
    return "...";
}

/* GNU Fortran makes a record of a COMMON block, or of what EQUIVALENCE joins: the fields are variables. */
bool is_common(tree decl)
{
    return is_fortran() && VAR_P(decl) && RECORD_OR_UNION_TYPE_P(TREE_TYPE(decl)) &&
           !TYPE_NAME(TREE_TYPE(decl));
}

name object_of_declaration(tree decl)
{
    const char *own = is_common(decl) ? NULL : own_name(decl);
    return {own ? own : "", false, TREE_TYPE(decl)};
}

name object(tree ref, int depth);

/* What the pointer that is a sum points to. */
name behind_sum(tree base, tree offset, int depth)
{
    name n = behind(base, depth);
    if (TREE_CODE(offset) == INTEGER_CST) {
        n.offset += (int64_t)TREE_INT_CST_LOW(offset); /* its type has no sign */
        return n;
    }
    if (!n.type || n.is_pointer)
        return {with_index(n.text, index_name(offset)), false, n.type};
    if (TREE_CODE(n.type) == ARRAY_TYPE)
        return {with_index(n.text, index_name(offset)), false, TREE_TYPE(n.type)};
    return n;
}

name behind_assigned(gassign *def, int depth)
{
    tree first = gimple_assign_rhs1(def);
    switch (gimple_assign_rhs_code(def)) {
    case POINTER_PLUS_EXPR:
    case PLUS_EXPR:
        if (name n = behind_sum(first, gimple_assign_rhs2(def), depth); !n.text.empty())
            return n;
        return behind_sum(gimple_assign_rhs2(def), first, depth);
    CASE_CONVERT:
    case SSA_NAME:
    case ADDR_EXPR:
        return behind(first, depth);
    default:
        break;
    }
    if (!gimple_assign_single_p(def) || !POINTER_TYPE_P(TREE_TYPE(first)))
        return {};
    return {object_text(object(first, depth)), true, TREE_TYPE(TREE_TYPE(first))};
}

name behind_phi(gphi *phi, int depth)
{
    for (unsigned i = 0; i < gimple_phi_num_args(phi); i++)
        if (name n = behind(gimple_phi_arg_def(phi, i), depth + deepest / 3); !n.text.empty())
            return n;
    return {};
}

name behind(tree pointer, int depth)
{
    if (depth > deepest)
        return {};
    if (TREE_CODE(pointer) == ADDR_EXPR)
        return object(TREE_OPERAND(pointer, 0), depth + 1);
    tree type = POINTER_TYPE_P(TREE_TYPE(pointer)) ? TREE_TYPE(TREE_TYPE(pointer)) : NULL_TREE;
    if (DECL_P(pointer))
        return {own_name(pointer) ? own_name(pointer) : "", true, type};
    if (TREE_CODE(pointer) != SSA_NAME)
        return {};
    if (type && own_name(SSA_NAME_VAR(pointer)))
        return {own_name(SSA_NAME_VAR(pointer)), true, type};
    gimple *def = SSA_NAME_DEF_STMT(pointer);
    if (gphi *phi = dyn_cast<gphi *>(def))
        return behind_phi(phi, depth);
    gassign *assigned = dyn_cast<gassign *>(def);
    return assigned ? behind_assigned(assigned, depth + 1) : name{};
}

name object_of_target_ref(tree ref, int depth)
{
    name n = behind(TMR_BASE(ref), depth + 1);
    if (n.text.empty() && TMR_INDEX2(ref))
        n = behind(TMR_INDEX2(ref), depth + 1);
    if (TMR_INDEX(ref) || TMR_INDEX2(ref)) {
        tree type = n.type && TREE_CODE(n.type) == ARRAY_TYPE ? TREE_TYPE(n.type) : n.type;
        n = {with_index(n.text, "..."), false, type};
    }
    return n;
}

/* What a reference concerns. */
name object(tree ref, int depth)
{
    if (DECL_P(ref))
        return object_of_declaration(ref);
    switch (TREE_CODE(ref)) {
    case COMPONENT_REF:
        return {with_field(object(TREE_OPERAND(ref, 0), depth), TREE_OPERAND(ref, 1)), false, TREE_TYPE(ref)};
    case ARRAY_REF:
    case ARRAY_RANGE_REF: {
        name n = object(TREE_OPERAND(ref, 0), depth);
        return {with_index(n.text, index_name(TREE_OPERAND(ref, 1))), false, TREE_TYPE(ref)};
    }
    case MEM_REF: {
        name n = behind(TREE_OPERAND(ref, 0), depth);
        return inside(n, TREE_INT_CST_LOW(TREE_OPERAND(ref, 1)), bytes_of(TREE_TYPE(ref)));
    }
    case TARGET_MEM_REF:
        return inside(object_of_target_ref(ref, depth), 0, bytes_of(TREE_TYPE(ref)));
    default:
        return handled_component_p(ref) ? object(TREE_OPERAND(ref, 0), depth) : name{};
    }
}

/* The address of the elements that a statement puts into a descriptor, whose first field it is, or NULL. */
tree address_put_into(tree descriptor, gimple *stmt)
{
    if (!gimple_assign_single_p(stmt) || TREE_CODE(gimple_assign_lhs(stmt)) != COMPONENT_REF)
        return NULL_TREE;
    tree lhs = gimple_assign_lhs(stmt), field = TREE_OPERAND(lhs, 1);
    bool first = TREE_OPERAND(lhs, 0) == descriptor && field == TYPE_FIELDS(TREE_TYPE(descriptor));
    return first ? gimple_assign_rhs1(stmt) : NULL_TREE;
}
} // namespace

std::string race_name_of(tree ref)
{
    return object_text(object(ref, 0));
}

std::string race_name_behind(tree pointer)
{
    return object_text(behind(pointer, 0));
}

std::string race_name_of_array(gimple *stmt, tree pointer)
{
    tree descriptor = TREE_CODE(pointer) == ADDR_EXPR ? TREE_OPERAND(pointer, 0) : NULL_TREE;
    if (!descriptor || !DECL_P(descriptor) || own_name(descriptor))
        return race_name_behind(pointer);
    for (basic_block bb = gimple_bb(stmt);; bb = single_pred(bb)) {
        for (gimple_stmt_iterator gsi = gsi_last_nondebug_bb(bb); !gsi_end_p(gsi); gsi_prev_nondebug(&gsi))
            if (tree address = address_put_into(descriptor, gsi_stmt(gsi)))
                return race_name_behind(address);
        if (!single_pred_p(bb))
            return "";
    }
}
