// The rows of the inspector: checks, offenders, what a click, a repair button and the keys do.
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "core/catalog/catalog.h"
#include "ui/look.h"
#include "ui/panels/inspector_rows.h"
#include "ui/panels/inspector_widget.h"
#include "ui/panels/repair_all.h"
#include "ui/panels/valence_histogram.h"
#include "ui/repair_edits.h"

namespace mw {

namespace {

constexpr int findingRole = Qt::UserRole, offenderRole = Qt::UserRole + 1;

}  // namespace

void Inspector::fill()
{
    const Inspection& i = *shown_;
    values_[0]->setText(look::count(i.vertices) + (i.isolated ? " + " + look::count(i.isolated) : QString()));
    values_[0]->setToolTip(i.isolated ? tr("%1 in faces, %2 isolated").arg(look::count(i.vertices), look::count(i.isolated)) : QString());
    values_[1]->setText(look::count(i.edges));
    values_[2]->setText(look::count(i.faces));
    values_[3]->setText(look::number(double(i.euler)));
    values_[4]->setText(i.genus ? look::number(double(*i.genus)) : tr("none"));
    values_[4]->setToolTip(i.genus ? QString() : tr("Only a manifold, orientable mesh without degenerate faces has one."));
    values_[5]->setText(look::count(i.components));
    tree_->clear();
    tree_->header()->resizeSection(1, 20);
    const auto hasButton = [](const Finding& f) { return !f.measured || (f.toFix() && !f.repair.empty()); };
    tree_->setColumnHidden(1, std::none_of(i.findings.begin(), i.findings.end(), hasButton));
    const size_t bad = i.toFix(), good = i.passed(), open = i.findings.size() - bad - good;
    const auto add = [&](const QString& title, const QString& figure, size_t first, size_t count) {
        QTreeWidgetItem* s = section(title, figure);
        for (size_t k = first; k < first + count; ++k) addFinding(s, k);
        return s;
    };
    if (bad > 0) addRepairAll(add(tr("To fix"), look::counted(bad, tr("kind"), tr("kinds")), 0, bad));
    if (open > 0) add(tr("Not yet measured"), look::counted(open, tr("check"), tr("checks")), bad, open);
    const QString passed = look::counted(good, tr("check"), tr("checks"));
    add(bad == 0 && open == 0 ? tr("Nothing to fix") : tr("Passed"), bad == 0 && open == 0 ? tr("%1 passed").arg(passed) : passed, bad + open, good);
    addValence();
    addFaceSizes();
}

QTreeWidgetItem* Inspector::section(const QString& title, const QString& figure)
{
    auto* s = new QTreeWidgetItem(tree_, {title});
    s->setFirstColumnSpanned(true);
    s->setData(0, InspectorRows::Section, true);
    s->setData(0, InspectorRows::SectionFigure, figure);
    s->setFlags(Qt::ItemIsEnabled);
    s->setExpanded(true);
    s->setData(0, Qt::AccessibleTextRole, title + ", " + figure);
    return s;
}

void Inspector::addSentence(QTreeWidgetItem* row, const QString& sentence)
{
    auto* s = new QTreeWidgetItem(row, {sentence});
    s->setData(0, InspectorRows::Sentence, true);
    s->setFirstColumnSpanned(true);
    s->setFlags(Qt::NoItemFlags);  // Down passes over it
}

void Inspector::addFinding(QTreeWidgetItem* under, size_t index)
{
    const Finding& f = shown_->findings[index];
    auto* row = new QTreeWidgetItem(under, {f.title, f.figure});
    row->setData(0, findingRole, int(index) + 1);
    row->setData(0, Qt::AccessibleTextRole, f.title + ", " + (f.passed() ? tr("passed") : f.inFull.isEmpty() ? f.figure : f.inFull));
    row->setData(0, Qt::AccessibleDescriptionRole, f.passed() ? f.checked : f.explanation);
    row->setIcon(0, f.passed()   ? look::icon("ok", look::tone().success)
                    : f.measured ? look::icon("warning", look::tone().warning)
                                 : look::icon("help", look::tone().text2));
    row->setForeground(1, f.toFix() ? look::tone().accentText : look::tone().text2);
    row->setToolTip(0, f.toFix() ? f.explanation + "\n" + tr("Click selects them all, Enter frames them.") : f.passed() ? f.checked : f.explanation);
    row->setToolTip(1, f.inFull);
    row->setFirstColumnSpanned(f.passed() || (f.measured && f.repair.empty()));
    addSentence(row, f.passed() ? f.checked : f.explanation);
    if (f.passed()) return row->setText(1, {});
    for (size_t k = 0; k < f.offenders.size(); ++k) {
        auto* o = new QTreeWidgetItem(row, {f.offenders[k].name, f.offenders[k].figure});
        o->setData(0, findingRole, int(index) + 1);
        o->setData(0, offenderRole, int(k) + 1);
        o->setFirstColumnSpanned(true);
        o->setForeground(1, look::tone().text2);
        o->setToolTip(0, tr("Click selects it, Enter or a double click frames it."));
    }
    if (f.total > f.offenders.size()) {
        auto* more = new QTreeWidgetItem(row, {tr("and %1 more").arg(look::count(f.total - f.offenders.size()))});
        more->setForeground(0, look::tone().text2);
        more->setFirstColumnSpanned(true);
        more->setFlags(Qt::ItemIsEnabled);
    }
    row->setExpanded(!f.measured || f.offenders.size() <= 8);
    if (!f.measured)
        addButton(row, f, tr("Measure"), tr("Measures in the background; it can be cancelled."), [this] { measure(shown_->mesh, true); });
    else if (!f.repair.empty())
        addButton(row, f, f.repairText, tr("Adds the modifier \"%1\".").arg(QString::fromStdString(operation(f.repair).title)), [this, f] {
            repair({{f.repair, f.repairValues, f.title}}, {f.id});
        });
    if (struck_.count(f.id)) strike(row);
}

void Inspector::addButton(QTreeWidgetItem* row, const Finding& f, const QString& text, const QString& tip, std::function<void()> run)
{
    auto* b = new QPushButton(text, tree_);
    b->setFixedHeight(20);
    b->setFocusPolicy(Qt::TabFocus);
    b->setObjectName((f.measured ? "repair-" : "measure-") + f.id);
    b->setAccessibleName(tr("%1: %2").arg(f.title, text));
    b->setToolTip(tip);
    b->setEnabled(!struck_.count(f.id));
    // Queued: what it does may take the button away.
    connect(b, &QPushButton::clicked, this, std::move(run), Qt::QueuedConnection);
    tree_->header()->resizeSection(1, std::max(tree_->header()->sectionSize(1), b->sizeHint().width() + 4));
    tree_->setItemWidget(row, 1, b);
}

void Inspector::addRepairAll(QTreeWidgetItem* section)
{
    if (shown_->mendings().empty()) return;
    auto* line = new QWidget(tree_);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 4, 0);
    row->addStretch(1);
    auto* b = new QPushButton(tr("Repair all..."), line);
    b->setFixedHeight(20);
    b->setFocusPolicy(Qt::TabFocus);
    b->setObjectName("inspect-repair-all");
    b->setToolTip(tr("Lists the modifiers that mend all of this, and what each would change"));
    row->addWidget(b);
    connect(b, &QPushButton::clicked, this, [this, b] {
        showRepairAll(session_, b, shown_, [this](const std::vector<Mending>& chosen) {
            std::set<QString> findings;
            for (const Finding& f : shown_->findings)
                if (std::any_of(chosen.begin(), chosen.end(), [&](const Mending& m) { return f.toFix() && m.operation == f.repair; }))
                    findings.insert(f.id);
            repair(chosen, findings);
        });
    });
    tree_->setItemWidget(section, 0, line);
}

void Inspector::strike(QTreeWidgetItem* row)
{
    QFont struck = tree_->font();
    struck.setStrikeOut(true);
    row->setFont(0, struck);
    row->setData(0, Qt::AccessibleDescriptionRole, tr("being repaired"));
}

void Inspector::addValence()
{
    QTreeWidgetItem* s = section(tr("Valence"), tr("%1 % regular").arg(int(std::round(100 * shown_->regular))));
    s->setToolTip(0, tr("Edges at a vertex. Regular: 6 inside a triangle mesh, 4 on its boundary; 4 and 3 where there are other faces."));
    addHistogram(s, ElementKind::Vertex);
    size_t sum = 0;
    for (const auto& [valence, n] : shown_->valences) sum += valence * n;
    addSentence(s, tr("The valences add up to %1: every edge counts at both its ends, 2 × %2.").arg(look::count(sum), look::count(shown_->edges)));
}

void Inspector::addFaceSizes()
{
    size_t sum = 0;
    for (const auto& [corners, n] : shown_->faceSizes) sum += corners * n;
    if (sum == 0) return;
    const bool triangles = shown_->faceSizes.size() == 1 && shown_->faceSizes.begin()->first == 3;
    QTreeWidgetItem* s = section(tr("Corners of faces"), triangles ? tr("all triangles") : QString());
    s->setToolTip(0, tr("Vertices of a face, which is also the number of its edges."));
    if (!triangles) addHistogram(s, ElementKind::Face);
    addSentence(s, tr("They add up to %1: as many half-edges have a face.").arg(look::count(sum)));
}

void Inspector::addHistogram(QTreeWidgetItem* section, ElementKind kind)
{
    auto* row = new QTreeWidgetItem(section);
    row->setFlags(Qt::ItemIsEnabled);
    row->setFirstColumnSpanned(true);
    auto* h = new ValenceHistogram(tree_);
    if (kind == ElementKind::Face) h->setFaces();
    h->setValences(kind == ElementKind::Face ? shown_->faceSizes : shown_->valences);
    connect(h, &ValenceHistogram::barClicked, this, [this, kind](size_t number, bool orMore) { selectCounted(kind, number, orMore); });
    tree_->setItemWidget(row, 0, h);
    row->setSizeHint(0, h->sizeHint());
}

const ElementSet* Inspector::elementsOf(const QTreeWidgetItem* row) const
{
    const int f = row ? row->data(0, findingRole).toInt() : 0, o = row ? row->data(0, offenderRole).toInt() : 0;
    if (!shown_ || f <= 0 || size_t(f) > shown_->findings.size()) return nullptr;
    const Finding& finding = shown_->findings[size_t(f) - 1];
    if (!finding.toFix()) return nullptr;
    return o > 0 ? &finding.offenders[size_t(o) - 1].elements : &finding.all;
}

// The elements belong to the level that was measured, so that one is shown.
void Inspector::select(const ElementSet& elements)
{
    const Scene& s = session_.document.scene();
    const Node* n = s.find(node_);
    if (!n || !n->mesh) return;
    const size_t level = size_t(std::max(0, level_->currentIndex())), levels = s.find(n->mesh)->stack.size();
    if (level > levels || levels == 0)
        session_.view.shownLevel.erase(n->mesh);
    else
        session_.view.shownLevel[n->mesh] = level;
    session_.view.flashes.clear();
    session_.view.dimOthers = dimmed_ = true;
    selecting_ = true;
    session_.document.select({{node_}, node_, elements});
    selecting_ = false;
    session_.view.touch();
}

void Inspector::selectionChanged()
{
    if (selecting_ || !dimmed_) return;
    dimmed_ = session_.view.dimOthers = false;
    session_.view.touch();
}

void Inspector::selectCounted(ElementKind kind, size_t number, bool orMore)
{
    QPointer<Inspector> self(this);
    const QString name = kind == ElementKind::Face ? tr("Select faces of %1 corners") : tr("Select vertices of valence %1");
    session_.jobs.start(name.arg(number), [self, kind, number, orMore, mesh = shown_->mesh](Progress&) {
        auto found = std::make_shared<const ElementSet>(kind == ElementKind::Face ? facesOfSize(mesh, number, orMore)
                                                                                  : verticesOfValence(mesh, number, orMore));
        return std::function<void()>([self, found] {
            if (self) self->select(*found);
        });
    });
}

void Inspector::frame(const QTreeWidgetItem* row)
{
    const ElementSet* e = elementsOf(row);
    if (!e || !session_.document.scene().find(node_)) return;
    const glm::dmat4 world = session_.document.scene().worldFromLocal(node_);
    const Bounds local = boundsOf(shown_->mesh, *e);
    Bounds b;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y, corner & 4 ? local.max.z : local.min.z);
        b.add(glm::dvec3(world * glm::dvec4(p, 1)));
    }
    // A single vertex has no size: some of what is around it shows where it is.
    const double least = 0.02 * shown_->mesh.bounds().diagonal();
    if (b.diagonal() < least) b.add(b.centre() - glm::dvec3(least / 2)), b.add(b.centre() + glm::dvec3(least / 2));
    session_.view.frameBounds(b);
}

void Inspector::flash(const QTreeWidgetItem* row)
{
    const ElementSet* e = elementsOf(row);
    if (!e && session_.view.flashes.empty()) return;
    session_.view.flashes.clear();
    if (e) {
        Mark m;
        m.node = node_;
        m.kind = e->kind;
        m.indices = e->indices;
        m.color = {1, 0.42f, 0.37f, 1};
        m.width = e->kind == ElementKind::Vertex ? 8 : 3;
        m.through = true;
        session_.view.flashes.push_back(std::move(m));
    }
    session_.view.touch();
}

// The modifiers go in after the level that was measured, and it is their result that is inspected next. One entry of the history.
void Inspector::repair(const std::vector<Mending>& mendings, const std::set<QString>& findings)
{
    const Node* n = session_.document.scene().find(node_);
    if (!n || !n->mesh || mendings.empty()) return;
    const size_t levels = session_.document.scene().find(n->mesh)->stack.size();
    const size_t level = std::min(size_t(std::max(0, level_->currentIndex())), levels);
    const bool result = level_->currentIndex() == level_->count() - 1;
    struck_ = findings;
    struckAt_ = session_.document.historyPosition() + 1;
    std::vector<Modifier> modifiers;
    for (const Mending& m : mendings) modifiers.push_back({{}, m.operation, m.values, true});
    if (session_.view.dimOthers) session_.document.select({{node_}, {}, {}});  // what is mended is there no more
    session_.view.shownLevel.erase(n->mesh);
    edits::insertModifiers(session_.document, node_, level, std::move(modifiers));
    if (!result) level_->setCurrentIndex(std::min(int(level + mendings.size()), level_->count() - 1));
    session_.view.touch();
    if (shown_) fill();
    update(false);
}

// After an undo, or when the stack was run and the mesh stayed as it was.
void Inspector::unstrike()
{
    if (struck_.empty() || !shown_ || !session_.document.scene().find(node_)) return;
    const MeshId id = session_.document.scene().node(node_).mesh;
    const auto e = session_.document.evaluation(id);
    const bool undone = session_.document.historyPosition() < struckAt_;
    const bool ran = e && id && e->levels.size() == session_.document.scene().find(id)->stack.size() && job_ == 0;
    if (!undone && !ran) return;
    struck_.clear();
    fill();
}

}  // namespace mw
