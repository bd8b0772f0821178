// Size and content hash of tables and element sets.
#include "core/mesh/table.h"

#include "core/math/hash.h"

namespace mw {

size_t byteSize(const Table& t)
{
    size_t n = sizeof(Table) + t.edges.size() * sizeof(uint32_t);
    for (const Column& c : t.columns) n += sizeof(Column) + c.name.size() + c.unit.size() + c.values.size() * sizeof(double);
    for (const auto& [name, value] : t.summary) n += sizeof(value) + name.size();
    for (const auto& [name, list] : t.lists) n += name.size() + list.size() * sizeof(uint32_t);
    return n;
}

uint64_t contentHash(const Table& t)
{
    Hasher h;
    h.number(uint64_t(t.rows));
    h.array(std::span<const uint32_t>(t.edges));
    h.number(t.columns.size());
    for (const Column& c : t.columns) {
        h.text(c.name);
        h.text(c.unit);
        h.array(std::span<const double>(c.values));
        h.number(c.categorical);
    }
    h.number(t.summary.size());
    for (const auto& [name, value] : t.summary) {
        h.text(name);
        h.array(std::span<const double>(&value, 1));
    }
    h.number(t.lists.size());
    for (const auto& [name, list] : t.lists) {
        h.text(name);
        h.array(std::span<const uint32_t>(list));
    }
    return h.value();
}

size_t byteSize(const ElementSet& s)
{
    return sizeof(ElementSet) + s.indices.size() * sizeof(uint32_t);
}

uint64_t contentHash(const ElementSet& s)
{
    Hasher h;
    h.number(uint64_t(s.kind));
    h.array(std::span<const uint32_t>(s.indices));
    return h.value();
}

}  // namespace mw
