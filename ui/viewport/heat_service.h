// What is computed to show meshes: tables that colour them (a query operation run as a job for each mesh shown, kept while that mesh is), normals.
#pragma once
#include <QObject>
#include <list>
#include <memory>

#include "core/catalog/catalog.h"
#include "render/renderer.h"
#include "ui/jobs.h"
#include "ui/viewport/normal_service.h"

namespace mw {

class HeatService : public QObject {
    Q_OBJECT

public:
    HeatService(Jobs& jobs, QObject* parent = nullptr) : QObject(parent), normals(jobs), jobs_(jobs)
    {
        connect(&normals, &NormalService::ready, this, &HeatService::ready);
    }
    NormalService normals;
    /// Null while it is being computed; ready() follows. Failed ones stay null and their text is said once by failed().
    /// Queries that work with another mesh are asked about `base`.
    std::shared_ptr<const HeatMap> heat(const Operation& query, const Mesh& mesh, const Mesh& base = {});

signals:
    void ready();
    void failed(const QString& text);

private:
    struct Entry {
        const Operation* query;
        Mesh mesh, base;
        std::shared_ptr<const HeatMap> heat;
        uint64_t asked;  // by the count of all questions
    };
    Entry* find(const Operation& query, const Mesh& mesh, const Mesh& base);
    Jobs& jobs_;
    std::list<Entry> entries_;
    uint64_t asked_ = 0;
};

}  // namespace mw
