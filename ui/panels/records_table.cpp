// See records_widget.h: its page, the tables, the queries, and what they draw.
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QStackedLayout>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/mesh/select.h"
#include "ui/look.h"
#include "ui/panels/records_widget.h"

namespace mw {

namespace {

constexpr int linkRole = Qt::UserRole, indexRole = Qt::UserRole + 1;
constexpr size_t handlesShown = 60;
constexpr const char* queryNames[] = {"V:-V", "V:-E", "V:-F", "E:-V", "E:-E", "E:-F", "F:-V", "F:-E", "F:-F"};

QString kindWords(ElementKind kind, size_t n)
{
    if (kind == ElementKind::Vertex) return look::counted(n, "vertex", "vertices");
    return kind == ElementKind::Edge ? look::counted(n, "edge", "edges") : look::counted(n, "face", "faces");
}

QToolButton* arrowButton(QWidget* parent, const char* icon, const QString& name, const QString& tip)
{
    auto* b = new QToolButton(parent);
    b->setIcon(look::icon(icon));
    b->setAccessibleName(name);
    b->setToolTip(tip);
    b->setAutoRaise(true);
    b->setProperty("small", true);
    b->setFixedSize(24, 24);
    b->setFocusPolicy(Qt::TabFocus);
    return b;
}

}  // namespace

void Records::makePage()
{
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    column->addWidget(makeBar(page));
    makeTable(page);
    column->addWidget(table_, 1);
    column->addWidget(makeQueries(page));
    pages_->addWidget(page);
}

QWidget* Records::makeBar(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);
    back_ = arrowButton(box, "undo", tr("Back"), tr("To the element before · Alt+Left"));
    forward_ = arrowButton(box, "redo", tr("Forward"), tr("To the element after · Alt+Right"));
    back_->setObjectName("records-back");
    forward_->setObjectName("records-forward");
    connect(back_, &QToolButton::clicked, this, [this] { travel(-1); });
    connect(forward_, &QToolButton::clicked, this, [this] { travel(1); });
    title_ = new QLabel(box);
    title_->setObjectName("records-title");
    title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    title_->setWordWrap(true);
    grid->addWidget(back_, 0, 0);
    grid->addWidget(forward_, 0, 1);
    grid->addWidget(title_, 0, 2);
    auto* label = new QLabel(tr("Draw"), box);
    drawing_ = new QComboBox(box);
    drawing_->addItems(
        {tr("Half-edges"), tr("Winged edge"), tr("Face and neighbours"), tr("Triangle adjacency"), tr("Answer of a query"), tr("Nothing")});
    drawing_->setObjectName("records-drawing");
    drawing_->setAccessibleName(tr("What is drawn in the view"));
    drawing_->setToolTip(tr("What is drawn in the view at the pick, with the letters of the book's figures"));
    drawing_->setFocusPolicy(Qt::TabFocus);
    label->setBuddy(drawing_);
    grid->addWidget(label, 1, 0, 1, 2);
    grid->addWidget(drawing_, 1, 2);
    grid->setColumnStretch(2, 1);
    connect(drawing_, &QComboBox::activated, this, [this] {
        if (RecordDrawing(drawing_->currentIndex()) == RecordDrawing::Answer && query_ < 0) query_ = 0;
        fillAnswer();
        draw();
    });
    return box;
}

void Records::makeTable(QWidget* parent)
{
    table_ = new QTableWidget(0, 4, parent);
    table_->setObjectName("records-table");
    table_->setAccessibleName(tr("Records at the pick"));
    table_->horizontalHeader()->hide();
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(22);
    table_->verticalHeader()->setMinimumSectionSize(18);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setTabKeyNavigation(false);
    table_->setMouseTracking(true);
    table_->setWordWrap(false);
    // Names as wide as they are, links share the rest.
    for (int c = 0; c < 4; ++c) table_->horizontalHeader()->setSectionResizeMode(c, c % 2 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    table_->installEventFilter(this);
    connect(table_, &QTableWidget::itemClicked, this, [this](QTableWidgetItem* cell) { follow(cell); });
    connect(table_, &QTableWidget::itemEntered, this, [this](QTableWidgetItem* cell) { flash(cell); });
    connect(table_, &QTableWidget::currentItemChanged, this, [this](QTableWidgetItem* cell) {
        if (cell && table_->hasFocus()) flash(cell);
    });
}

QWidget* Records::makeQueries(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    auto* bar = new look::SectionBar(tr("The nine queries"), box);
    grid->addWidget(bar, 0, 0, 1, 3);
    const QString kinds[] = {tr("vertex"), tr("edge"), tr("face")}, many[] = {tr("vertices"), tr("edges"), tr("faces")};
    for (int q = 0; q < 9; ++q) {
        auto* b = queries_[q] = new QPushButton(queryNames[q], box);
        b->setObjectName(QString("records-query-%1").arg(q));
        b->setCheckable(true);
        b->setProperty("segment", true);
        b->setFixedHeight(22);
        b->setFocusPolicy(Qt::TabFocus);
        b->setToolTip(tr("The %1 beside this %2").arg(many[q % 3], kinds[q / 3]));
        b->setAccessibleName(tr("%1 beside the %2").arg(many[q % 3], kinds[q / 3]));
        grid->addWidget(b, 1 + q / 3, q % 3);
        connect(b, &QPushButton::clicked, this, [this, q](bool on) {
            query_ = on ? q : -1;
            drawing_->setCurrentIndex(int(on ? RecordDrawing::Answer : RecordDrawing::Halfedge));
            fillAnswer();
            draw();
        });
    }
    for (int c = 0; c < 3; ++c) grid->setColumnStretch(c, 1);
    answer_ = new QLabel(box);
    answer_->setObjectName("records-answer");
    answer_->setWordWrap(true);
    answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    answer_->setMinimumHeight(answer_->fontMetrics().lineSpacing() * 2);
    answer_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    grid->addWidget(answer_, 4, 0, 1, 3);
    selectAnswer_ = new QPushButton(tr("Select them"), box);
    selectAnswer_->setFixedHeight(22);
    selectAnswer_->setFocusPolicy(Qt::TabFocus);
    selectAnswer_->setToolTip(tr("Selects what the query found"));
    selectAnswer_->setObjectName("records-select-answer");
    connect(selectAnswer_, &QPushButton::clicked, this, [this] {
        if (const ElementSet found = found_; !found.indices.empty()) {
            select(found);
            update();
        }
    });
    grid->addWidget(selectAnswer_, 5, 0, 1, 3, Qt::AlignLeft);
    return box;
}

void Records::fill()
{
    title_->setText(wordsOf(*mesh_, here_));
    back_->setEnabled(pathAt_ > 0);
    forward_->setEnabled(pathAt_ + 1 < path_.size());
    const int row = table_->currentRow(), column = table_->currentColumn();
    const QSignalBlocker quiet(table_);
    table_->clearSpans();
    table_->setRowCount(0);
    const std::vector<RecordTable> tables = recordTables(*mesh_, place_);
    for (const RecordTable& t : tables) addTable(t);
    if (tables.empty()) addTable({"nothing", tr("No face has this vertex: it has no records."), {}});
    if (place_.halfedge == none && place_.face != none) addTable({"nothing", tr("Not in the edge structures: a vertex is repeated."), {}});
    if (row >= 0 && row < table_->rowCount()) table_->setCurrentCell(row, column);
    fillAnswer();
}

void Records::addTable(const RecordTable& table)
{
    const int heading = table_->rowCount();
    table_->insertRow(heading);
    auto* title = new QTableWidgetItem(table.title);
    title->setFlags(Qt::ItemIsEnabled);
    QFont bold = table_->font();
    bold.setBold(true);
    title->setFont(bold);
    title->setBackground(look::tone().raised);
    table_->setItem(heading, 0, title);
    table_->setSpan(heading, 0, 1, 4);
    for (size_t i = 0; i < table.cells.size(); ++i) {
        if (i % 2 == 0) table_->insertRow(table_->rowCount());
        addCell(table_->rowCount() - 1, int(i % 2) * 2, table.cells[i]);
    }
}

void Records::addCell(int row, int column, const RecordCell& cell)
{
    auto* name = new QTableWidgetItem(cell.name);
    name->setFlags(Qt::ItemIsEnabled);
    name->setForeground(look::tone().text2);
    QFont small = table_->font();
    small.setPointSizeF(0.88 * small.pointSizeF());
    name->setFont(small);
    name->setToolTip(cell.name);
    table_->setItem(row, column, name);
    if (cell.name.isEmpty()) return;
    const bool nothing = cell.link.to == RecordLink::To::Nothing;
    auto* value = new QTableWidgetItem(cell.missing.isEmpty() ? handleOf(cell.link) : cell.missing);
    value->setFlags(nothing ? Qt::ItemIsEnabled : Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    value->setForeground(!cell.missing.isEmpty() ? look::roleTextColor(Role::Rejected) : nothing ? look::tone().text2 : look::tone().accentText);
    value->setToolTip(cell.missing.isEmpty() ? wordsOf(*mesh_, cell.link)
                                             : tr("No triangle beyond this side: %1 stands again").arg(handleOf(cell.link)));
    value->setData(Qt::AccessibleTextRole, cell.name + ", " + wordsOf(*mesh_, cell.link));
    if (!nothing) {
        value->setData(linkRole, int(cell.link.to));
        value->setData(indexRole, cell.link.index);
    }
    table_->setItem(row, column + 1, value);
}

void Records::fillAnswer()
{
    for (int q = 0; q < 9; ++q) {
        queries_[q]->setChecked(q == query_);
        queries_[q]->setEnabled(askedAt(place_, Adjacency::Query(q)).to != RecordLink::To::Nothing);
    }
    found_ = {};
    selectAnswer_->setEnabled(false);
    if (query_ < 0) return answer_->setText(tr("Choose a query: a:-b finds what is of kind b beside one of kind a."));
    const RecordLink asked = askedAt(place_, Adjacency::Query(query_));
    if (asked.to == RecordLink::To::Nothing) return answer_->setText(tr("There is nothing here to ask about."));
    found_ = answerOf(*mesh_, asked, Adjacency::Query(query_));
    const size_t n = countOf(found_);
    selectAnswer_->setEnabled(n > 0);
    const QString handles = handlesOf(*mesh_, found_, handlesShown);
    answer_->setText(tr("%1 of %2: %3%4").arg(queryNames[query_], handleOf(asked), kindWords(found_.kind, n), n > 0 ? ": " + handles : QString()));
}

// Only the panel in front draws, and takes back no more than it drew.
void Records::draw()
{
    const bool wanted = isVisible() && mesh_ && here_.to != RecordLink::To::Nothing && session_.document.scene().find(node_);
    if (!wanted && !drawn_) return;
    session_.view.sketch = {};
    if (wanted) {
        const glm::dmat4 world = session_.document.scene().worldFromLocal(node_);
        const auto drawing = RecordDrawing(drawing_->currentIndex());
        if (drawing == RecordDrawing::Answer && query_ >= 0)
            session_.view.sketch = sketchOfAnswer(*mesh_, askedAt(place_, Adjacency::Query(query_)), found_, node_, world);
        else
            session_.view.sketch = sketchOf(*mesh_, place_, drawing, node_, world);
    }
    drawn_ = wanted;
    session_.view.touch();
}

std::optional<RecordLink> Records::linkOf(const QTableWidgetItem* cell) const
{
    if (!cell || !cell->data(linkRole).isValid()) return {};
    return RecordLink{RecordLink::To(cell->data(linkRole).toInt()), cell->data(indexRole).toUInt()};
}

void Records::follow(const QTableWidgetItem* cell)
{
    if (const auto link = linkOf(cell)) go(*link);
}

void Records::flash(const QTableWidgetItem* cell)
{
    const auto link = linkOf(cell);
    table_->viewport()->setCursor(link ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (!link && session_.view.flashes.empty()) return;
    session_.view.flashes.clear();
    if (link && mesh_) {
        const ElementSet elements = mw::elementsOf(*mesh_, *link);
        Mark m;
        m.node = node_;
        m.kind = elements.kind;
        m.indices = elements.indices;
        m.color = {1, 1, 1, elements.kind == ElementKind::Face ? 0.5f : 1.f};
        m.width = elements.kind == ElementKind::Vertex ? 10 : 5;
        m.through = elements.kind != ElementKind::Face;
        session_.view.flashes.push_back(std::move(m));
    }
    session_.view.touch();
}

}  // namespace mw
