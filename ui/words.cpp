#include "ui/words.h"

#include <QLocale>

namespace mw {

QString grouped(size_t n)
{
    return QLocale(QLocale::English).toString(qulonglong(n));
}

QString counted(size_t n, const QString& one, const QString& many)
{
    return grouped(n) + ' ' + (n == 1 ? one : many);
}

QString nodeName(const Scene& scene, NodeId id)
{
    const Node& n = scene.node(id);
    if (!n.name.empty()) return QString::fromStdString(n.name);
    const MeshObject* mesh = scene.find(n.mesh);
    if (mesh && !mesh->name.empty()) return QString::fromStdString(mesh->name);
    return QString("%1 %2")
        .arg(n.joint == Node::Joint::Joint     ? "Joint"
             : n.joint == Node::Joint::EndSite ? "End"
             : mesh                            ? "Mesh"
                                               : "Node")
        .arg(id.value);
}

QString sizeText(qint64 bytes)
{
    if (bytes < 1000) return counted(size_t(std::max<qint64>(0, bytes)), "byte", "bytes");
    const char* units[] = {"kB", "MB", "GB"};
    double v = double(bytes);
    int unit = -1;
    while (v >= 1000 && unit < 2) v /= 1000, ++unit;
    return QString::number(v, 'f', v < 10 ? 1 : 0) + ' ' + units[unit];
}

QString timeText(double seconds)
{
    if (seconds < 0.0005) return "0 ms";
    if (seconds < 1) return QString::number(seconds * 1000, 'f', 0) + " ms";
    return QString::number(seconds, 'f', seconds < 10 ? 1 : 0) + " s";
}

QString countsText(const Mesh& mesh)
{
    return mesh.faceCount() ? grouped(mesh.faceCount()) + " F" : grouped(mesh.vertexCount()) + " V";
}

QString elementsText(const ElementSet& set)
{
    const size_t n = set.kind == ElementKind::Edge ? set.indices.size() / 2 : set.indices.size();
    switch (set.kind) {
        case ElementKind::Vertex:
            return counted(n, "vertex", "vertices") + " selected";
        case ElementKind::Edge:
            return counted(n, "edge", "edges") + " selected";
        default:
            return counted(n, "face", "faces") + " selected";
    }
}

}  // namespace mw
