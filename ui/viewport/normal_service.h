// Normals weighted other than by area for meshes that are shown: a job for each large one, kept while it is shown.
#pragma once
#include <QObject>
#include <list>

#include "core/mesh/weighted_normals.h"
#include "ui/jobs.h"

namespace mw {

class NormalService : public QObject {
    Q_OBJECT

public:
    NormalService(Jobs& jobs, QObject* parent = nullptr) : QObject(parent), jobs_(jobs) {}
    /// The mesh with such normals as an attribute; as it is when it has its own, when they are those it is drawn with anyway, and while they are
    /// being computed: ready() follows.
    Mesh shown(const Mesh& mesh, NormalWeight weight);

signals:
    void ready();

private:
    struct Entry {
        NormalWeight weight;
        Mesh mesh;
        std::optional<Attribute> normals;
    };
    Jobs& jobs_;
    std::list<Entry> entries_;  // most recent first
};

}  // namespace mw
