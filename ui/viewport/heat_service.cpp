#include "ui/viewport/heat_service.h"

#include "core/catalog/others.h"
#include "core/mesh/same_mesh.h"

namespace mw {

namespace {

/// Queries ask for texture coordinates and colours as well.
bool sameAll(const Mesh& a, const Mesh& b)
{
    return sameMesh(a, b) && sameAttributes(a, b);
}

}  // namespace

HeatService::Entry* HeatService::find(const Operation& query, const Mesh& mesh, const Mesh& base)
{
    for (Entry& e : entries_)
        if (e.query == &query && sameAll(e.mesh, mesh) && sameAll(e.base, base)) return &e;
    return nullptr;
}

std::shared_ptr<const HeatMap> HeatService::heat(const Operation& query, const Mesh& mesh, const Mesh& base)
{
    const Mesh other = needsOthers(query) ? base : Mesh();
    ++asked_;
    if (Entry* e = find(query, mesh, other)) {
        e->asked = asked_;
        return e->heat;
    }
    // What is shown is asked for with every picture, in each of several views for all of them.
    std::erase_if(entries_, [this](const Entry& e) { return entries_.size() > 16 && e.asked + 64 * entries_.size() < asked_; });
    entries_.push_front({&query, mesh, other, nullptr, asked_});
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
