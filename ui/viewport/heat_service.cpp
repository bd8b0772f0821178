#include "ui/viewport/heat_service.h"

#include "core/catalog/others.h"

namespace mw {
namespace {

bool same(const Mesh& a, const Mesh& b)
{
    return a.positions().id() == b.positions().id() && a.cornerVertex().id() == b.cornerVertex().id();
}

}  // namespace

HeatService::Entry* HeatService::find(const Operation& query, const Mesh& mesh, const Mesh& base)
{
    for (Entry& e : entries_)
        if (e.query == &query && same(e.mesh, mesh) && same(e.base, base)) return &e;
    return nullptr;
}

std::shared_ptr<const HeatMap> HeatService::heat(const Operation& query, const Mesh& mesh, const Mesh& base)
{
    const Mesh other = needsOthers(query) ? base : Mesh();
    if (const Entry* e = find(query, mesh, other)) return e->heat;
    entries_.push_front({&query, mesh, other, nullptr});
    if (entries_.size() > 16) entries_.pop_back();
    jobs_.start(
        "Colour by " + QString::fromStdString(query.title),
        [this, op = &query, mesh, other](Progress& progress) -> std::function<void()> {
            Others others;
            for (const Parameter& p : op->parameters)
                if (p.type == ParameterType::Object) others.emplace(p.name, other);
            auto table = std::make_shared<Table>(std::get<Table>(apply(*op, mesh, {}, &progress, others)));
            auto map = std::make_shared<HeatMap>();
            if (!table->columns.empty()) std::tie(map->low, map->high) = heatRange(table->columns.front());
            map->table = std::move(table);
            return [this, op, mesh, other, map] {
                if (Entry* e = find(*op, mesh, other)) e->heat = map->table->columns.empty() ? nullptr : map;
                emit ready();
            };
        },
        [this](const QString& text) { emit failed(text); });
    return nullptr;
}

}  // namespace mw
