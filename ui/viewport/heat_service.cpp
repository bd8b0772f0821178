#include "ui/viewport/heat_service.h"

namespace mw {

std::shared_ptr<const HeatMap> HeatService::heat(const Operation& query, const Mesh& mesh)
{
    for (const Entry& e : entries_)
        if (e.query == &query && e.mesh.positions().id() == mesh.positions().id() && e.mesh.cornerVertex().id() == mesh.cornerVertex().id())
            return e.heat;
    entries_.push_front({&query, mesh, nullptr});
    if (entries_.size() > 16) entries_.pop_back();
    jobs_.start(
        "Colour by " + QString::fromStdString(query.title),
        [this, op = &query, mesh](Progress& progress) -> std::function<void()> {
            auto table = std::make_shared<Table>(std::get<Table>(apply(*op, mesh, {}, &progress)));
            auto map = std::make_shared<HeatMap>();
            if (!table->columns.empty()) std::tie(map->low, map->high) = heatRange(table->columns.front());
            map->table = std::move(table);
            return [this, op, mesh, map] {
                for (Entry& e : entries_)
                    if (e.query == op && e.mesh.positions().id() == mesh.positions().id() && e.mesh.cornerVertex().id() == mesh.cornerVertex().id())
                        e.heat = map->table->columns.empty() ? nullptr : map;
                emit ready();
            };
        },
        [this](const QString& text) { emit failed(text); });
    return nullptr;
}

}  // namespace mw
