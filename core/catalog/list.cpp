// The list of operations, in menu order: one entry each.
#include "core/catalog/entries.h"

namespace mw {

std::span<const Operation> catalog()
{
    static const std::vector<Operation> operations = {};
    return operations;
}

}  // namespace mw
