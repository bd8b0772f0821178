// Numbers and counts as the window writes them (ui/UI.md 6).
#pragma once
#include <QString>

#include "core/mesh/mesh.h"
#include "core/mesh/table.h"
#include "core/scene/scene.h"

namespace mw {

QString grouped(size_t n);                                           ///< "69,451"
QString counted(size_t n, const QString& one, const QString& many);  ///< "1 edge", "40 edges"
QString nodeName(const Scene& scene, NodeId id);                     ///< its name, or one that says what it is: "Joint 12"
QString sizeText(qint64 bytes);                                      ///< "820 bytes", "1.2 MB"
QString timeText(double seconds);                                    ///< "38 ms", "1.4 s"
QString countsText(const Mesh& mesh);                                ///< "69,451 F", or vertices where there are no faces
QString elementsText(const ElementSet& set);                         ///< "40 edges selected"

}  // namespace mw
