#include "ui/panels/matrix_product.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/scene/scene_pose.h"
#include "ui/look.h"
#include "ui/panels/fold.h"
#include "ui/playback.h"
#include "ui/words.h"

namespace mw {
namespace {

QString cell(double v)
{
    const double size = std::abs(v);
    if (size < 5e-4) return "0";
    if (std::abs(v - 1) < 5e-7) return "1";
    const QString text = size >= 1e5 ? QString::number(v, 'g', 3)
                                     : QLocale(QLocale::English)
                                           .toString(v, 'f',
                                                     size >= 1000  ? 0
                                                     : size >= 100 ? 1
                                                                   : 3);
    return QString(text).replace('-', QChar(0x2212));
}

/// Rows between upright lines; the last column, the place, in the text's own colour.
QString matrixText(const glm::dmat4& m)
{
    QString rows;
    for (int r = 0; r < 4; ++r) {
        rows += "<tr>";
        for (int c = 0; c < 4; ++c) {
            const QString edge = c == 0 ? "border-left: 1px solid %1;" : c == 3 ? "border-right: 1px solid %1;" : "";
            rows += QString("<td align='right' style='padding: 1px 5px; color: %3; %1'>%2</td>")
                        .arg(edge.isEmpty() ? edge : edge.arg(look::tone().text2.name()), cell(m[c][r]),
                             (c == 3 ? look::tone().text : look::tone().text2).name());
        }
        rows += "</tr>";
    }
    return "<table cellspacing='0'>" + rows + "</table>";
}

bool isIdentity(const glm::dmat4& m)
{
    return m == glm::dmat4(1);
}

}  // namespace

MatrixProduct::MatrixProduct(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    box_ = new QVBoxLayout(this);
    box_->setContentsMargins(0, 0, 0, 0);
    box_->setSpacing(4);
}

void MatrixProduct::setNode(NodeId id)
{
    std::vector<NodeId> chain;
    const Scene& scene = session_.document.scene();
    for (NodeId a = scene.find(id) ? id : NodeId{}; a; a = scene.node(a).parent) chain.insert(chain.begin(), a);
    const bool named = formula_ && chain == chain_;
    if (named && id == node_) return refresh();
    node_ = id;
    chain_ = std::move(chain);
    rebuild();
}

MatrixProduct::Factor MatrixProduct::factor(const QString& title, const QString& key, bool open, NodeId node)
{
    auto* fold = new Fold(title, key, open, this);
    auto* numbers = new QLabel(fold);
    numbers->setTextFormat(Qt::RichText);
    numbers->setTextInteractionFlags(Qt::TextSelectableByMouse);
    numbers->setToolTip("Acts on columns; the last column is the place, in metres.");
    numbers->setFont(look::monospace());
    numbers->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    fold->inside()->addWidget(numbers);
    connect(fold, &Fold::opened, this, [this] { refresh(); });
    box_->addWidget(fold);
    return {node, fold, numbers};
}

void MatrixProduct::rebuild()
{
    while (QLayoutItem* item = box_->takeAt(0)) {
        if (item->widget()) {
            item->widget()->hide();
            item->widget()->deleteLater();
        }
        delete item;
    }
    factors_.clear();
    offset_ = {};
    const Scene& scene = session_.document.scene();
    formula_ = new QLabel(this);
    formula_->setObjectName("matrixFormula");
    formula_->setWordWrap(true);
    formula_->setTextFormat(Qt::RichText);
    formula_->setToolTip("A point of the node is multiplied from the right: first by its own matrix, last by its root's.");
    box_->addWidget(formula_);
    for (const NodeId id : chain_)
        factors_.push_back(factor(nodeName(scene, id), QString("matrix %1").arg(id.value), id == node_ && chain_.size() < 3, id));
    product_ = factor("World: the product", "matrix product", true, node_);
    product_.numbers->setObjectName("matrixProduct");
    for (const SkinId s : scene.skins()) {
        const Skin& skin = *scene.find(s);
        if (std::find(skin.joints.begin(), skin.joints.end(), node_) == skin.joints.end()) continue;
        offset_ = factor("Offset: joint from mesh, at rest", "matrix offset", false, node_);
        break;
    }
    refresh();
}

void MatrixProduct::write(const Factor& f, const glm::dmat4& m, const QString& note)
{
    if (f.fold->isOpen()) f.numbers->setText(matrixText(m));
    f.fold->setTitle(note.isEmpty() ? f.fold->head()->text() : note);
}

void MatrixProduct::refresh()
{
    const Scene& scene = session_.document.scene();
    if (!formula_ || !scene.find(node_)) return;
    const ScenePose pose = session_.playback ? session_.playback->pose() : ScenePose();
    QString product;
    glm::dmat4 world(1);
    for (const Factor& f : factors_) {
        const Node* n = scene.find(f.node);
        if (!n) return;
        const auto posed = pose.locals.find(f.node);
        const glm::dmat4 local = (posed == pose.locals.end() ? n->local : posed->second).matrix();
        world = world * local;
        const QString name = nodeName(scene, f.node);
        write(f, local, isIdentity(local) ? name + "  = I" : name);
        product += (product.isEmpty() ? "" : " · ") + QString("M<sub>%1</sub>").arg(name.toHtmlEscaped());
    }
    formula_->setText(QString("M<sub>world</sub> = ") + product);
    write(product_, world);
    if (!offset_.fold) return;
    for (const SkinId s : scene.skins()) {
        const Skin& skin = *scene.find(s);
        const auto at = std::find(skin.joints.begin(), skin.joints.end(), node_);
        if (at == skin.joints.end()) continue;
        write(offset_, skin.inverseBind[size_t(at - skin.joints.begin())]);
        return;
    }
}

}  // namespace mw
