// What tests of single panels stand on: a document and the services that a panel is given, without a window.
#pragma once
#include <QTest>
#include <QWidget>
#include <memory>

#include "core/io/io.h"
#include "ui/session.h"

namespace mw {

struct PanelDesk {
    Document document;
    Jobs jobs;
    ViewState view;
    StepSession steps{document, jobs};
    Session session{document, jobs, view, steps};
    NodeId node;  ///< that shows the mesh
    std::unique_ptr<QWidget> panel;

    PanelDesk() = default;
    /// A document whose one node, selected, shows the mesh.
    explicit PanelDesk(const Mesh& mesh, const char* name = "sheet", glm::dvec3 place = glm::dvec3(0))
    {
        Scene scene = sceneOf(mesh, name);
        node = scene.roots().front();
        Node n = scene.node(node);
        n.local.translation = place;
        scene.set(node, std::move(n));
        document.open(std::move(scene), {}, "New");
        document.select({{node}, {}, {}});
    }
    void show(QWidget* (*make)(Session&, QWidget*), int width, int height, bool untilInPlace = true)
    {
        panel.reset(make(session, nullptr));
        panel->resize(width, height);
        panel->show();
        // Until then a busy window manager may still move and resize it, away from under the pointer.
        if (untilInPlace) static_cast<void>(QTest::qWaitForWindowExposed(panel.get()));
    }
};

}  // namespace mw
