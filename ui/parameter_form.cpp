#include "ui/parameter_form.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QWheelEvent>
#include <cmath>

namespace mw {
namespace {

constexpr int sliderSteps = 1000;
constexpr double widest = 1e9;

QString numberText(double v)
{
    return QLocale(QLocale::English).toString(v, 'g', 6).replace('-', QChar(0x2212));
}

double asDouble(const ParameterValue& v)
{
    if (const auto* i = std::get_if<int64_t>(&v)) return double(*i);
    if (const auto* d = std::get_if<double>(&v)) return *d;
    return 0;
}

QString unitSuffix(const About& a)
{
    if (a.unit.empty()) return {};
    const QString u = QString::fromStdString(a.unit);
    return u == "°" || u == "degrees" ? QString("°") : " " + u;
}

// A slider position for a value in the soft range, and back.
struct SliderScale {
    double low, high;
    bool logarithmic;
    int of(double v) const
    {
        const double t = logarithmic ? std::log(std::max(v, low) / low) / std::log(high / low) : (v - low) / (high - low);
        return int(std::lround(sliderSteps * std::clamp(t, 0.0, 1.0)));
    }
    double at(int s) const
    {
        const double t = double(s) / sliderSteps;
        return logarithmic ? low * std::pow(high / low, t) : low + t * (high - low);
    }
};

std::optional<SliderScale> scaleOf(const Parameter& p)
{
    const About& a = p.about;
    SliderScale s{std::isnan(a.softMin) ? a.min : a.softMin, std::isnan(a.softMax) ? a.max : a.softMax, a.logarithmic};
    if (!std::isfinite(s.low) || !std::isfinite(s.high) || !(s.low < s.high)) return std::nullopt;
    if (s.logarithmic && s.low <= 0) s.low = p.type == ParameterType::Integer ? 1 : s.high * 1e-6;
    return s;
}

// Three significant digits are enough for what a slider says.
double rounded(double v, bool integral)
{
    if (integral || v == 0) return std::round(v);
    const double unit = std::pow(10, std::floor(std::log10(std::abs(v))) - 2);
    return std::round(v / unit) * unit;
}

QString tipOf(const Parameter& p)
{
    const About& a = p.about;
    QString tip = QString::fromStdString(a.help);
    if (std::isfinite(a.min) && std::isfinite(a.max))
        tip += QString(" %1 to %2%3.").arg(numberText(a.min), numberText(a.max), unitSuffix(a));
    else if (std::isfinite(a.min))
        tip += QString(" At least %1%2.").arg(numberText(a.min), unitSuffix(a));
    return tip + " Double click the label for " + valueText(p, p.initial).section(' ', -1) + ".";
}

QString sentence(const std::string& word)
{
    QString s = QString::fromStdString(word);
    s.replace('-', ' ');
    if (!s.isEmpty()) s[0] = s[0].toUpper();
    return s;
}

/// Its list is made when it opens.
class LateBox : public QComboBox {
public:
    explicit LateBox(QWidget* parent) : QComboBox(parent) {}
    std::function<void()> fill;
    void showPopup() override
    {
        fill();
        QComboBox::showPopup();
    }
};

}  // namespace

QString valueText(const Parameter& p, const ParameterValue& v)
{
    const QString title = QString::fromStdString(p.about.title).toLower();
    if (const auto* b = std::get_if<bool>(&v)) return title + (*b ? " on" : " off");
    if (const auto* s = std::get_if<std::string>(&v)) return title + " " + QString::fromStdString(*s);
    if (const auto* q = std::get_if<glm::dvec3>(&v)) return title + " " + numberText(q->x) + ", " + numberText(q->y) + ", " + numberText(q->z);
    return title + " " + (p.type == ParameterType::Integer ? QLocale(QLocale::English).toString(qlonglong(asDouble(v))) : numberText(asDouble(v))) +
           unitSuffix(p.about);
}

ParameterForm::ParameterForm(std::vector<Parameter> parameters, ParameterValues values, QWidget* parent) : QWidget(parent), values_(std::move(values))
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnMinimumWidth(0, 104);
    grid->setColumnStretch(1, 1);
    rows_.reserve(parameters.size());
    for (Parameter& p : parameters) {
        rows_.push_back({std::move(p), nullptr, nullptr, nullptr, {}});
        makeRow(rows_.back());
        const int r = 2 * int(rows_.size()) - 1;  // the row above is for labels of a narrow form
        grid->addWidget(rows_.back().label, r, 0);
        grid->addWidget(rows_.back().editor, r, 1);
    }
    debounce_.setSingleShot(true);
    debounce_.setInterval(120);
    connect(&debounce_, &QTimer::timeout, this, [this] { emit edited(values_); });
    refresh();
}

QWidget* ParameterForm::field(const QString& name) const
{
    for (const Row& r : rows_)
        if (r.parameter.name == name.toStdString()) return r.field;
    return nullptr;
}

void ParameterForm::makeRow(Row& row)
{
    const Parameter& p = row.parameter;
    const QString title = QString::fromStdString(p.about.title.empty() ? p.name : p.about.title);
    row.label = new QLabel(title, this);
    row.label->setToolTip(tipOf(p));
    row.label->installEventFilter(this);
    switch (p.type) {
        case ParameterType::Integer:
        case ParameterType::Number:
            row.editor = numberEditor(row);
            break;
        case ParameterType::Choice:
            row.editor = choiceEditor(row);
            break;
        case ParameterType::Point:
            row.editor = pointEditor(row);
            break;
        case ParameterType::Flag: {
            auto* box = new QCheckBox(this);
            connect(box, &QCheckBox::toggled, this, [this, p](bool on) { change(p, on, true); });
            row.show = [box](const ParameterValue& v) { box->setChecked(std::get<bool>(v)); };
            row.editor = row.field = box;
            break;
        }
        case ParameterType::Object:
            row.editor = objectEditor(row);
            break;
        default:
            row.editor = textEditor(row);
    }
    row.field->setAccessibleName(title);
    row.editor->setToolTip(tipOf(p));
    row.label->setBuddy(row.field);
}

QWidget* ParameterForm::numberEditor(Row& row)
{
    const Parameter& p = row.parameter;
    const bool integral = p.type == ParameterType::Integer;
    auto* holder = new QWidget(this);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    auto* box = new NumberBox(holder);
    box->integral = integral;
    box->setRange(std::max(p.about.min, -widest), std::min(p.about.max, widest));
    box->setSuffix(unitSuffix(p.about));
    if (box->suffix().size() > 4)  // "257 samples"
        box->setFixedWidth(std::max(108, box->fontMetrics().horizontalAdvance("0000" + box->suffix()) + 16));
    const auto value = [integral](double v) -> ParameterValue { return integral ? ParameterValue(int64_t(std::llround(v))) : ParameterValue(v); };
    QSlider* slider = nullptr;
    const auto scale = scaleOf(p);
    if (scale) {
        slider = new QSlider(Qt::Horizontal, holder);
        slider->setRange(0, sliderSteps);
        slider->setFocusPolicy(Qt::TabFocus);
        slider->setMinimumWidth(24);  // in narrow docks it is the slider that gives way
        slider->setAccessibleName(QString::fromStdString(p.about.title));
        slider->installEventFilter(this);
        line->addWidget(slider, 1);
        connect(slider, &QSlider::sliderPressed, this, [this] { editing_ = true; });
        connect(slider, &QSlider::valueChanged, this, [=, this](int s) {
            if (showing_) return;
            const double v = std::clamp(rounded(scale->at(s), integral), box->minimum(), box->maximum());
            change(p, value(v), !slider->isSliderDown());
        });
        connect(slider, &QSlider::sliderReleased, this, [this, p] {
            editing_ = false;
            change(p, valueOf(p, values_), true);
        });
    } else {
        line->addStretch(1);
    }
    line->addWidget(box);
    connect(box, &NumberBox::valueChanged, this, [this, p, value](double v) {
        if (!showing_) change(p, value(v), true);
    });
    connect(box, &NumberBox::outOfRange, box, [box](bool out) {
        box->setProperty("bad", out);
        box->style()->unpolish(box);
        box->style()->polish(box);
    });
    row.show = [box, slider, scale](const ParameterValue& v) {
        box->setValue(asDouble(v));
        if (slider && !slider->isSliderDown()) slider->setValue(scale->of(asDouble(v)));
    };
    row.field = box;
    return holder;
}

QWidget* ParameterForm::choiceEditor(Row& row)
{
    const Parameter& p = row.parameter;
    if (p.choices.size() > 3) {
        auto* combo = new QComboBox(this);
        for (const auto& c : p.choices) combo->addItem(sentence(c), QString::fromStdString(c));
        combo->setFocusPolicy(Qt::TabFocus);
        combo->installEventFilter(this);
        connect(combo, &QComboBox::activated, this, [this, p, combo](int) { change(p, combo->currentData().toString().toStdString(), true); });
        row.show = [combo](const ParameterValue& v) { combo->setCurrentIndex(combo->findData(QString::fromStdString(std::get<std::string>(v)))); };
        return row.field = combo;
    }
    auto* holder = new QWidget(this);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(0);
    auto* group = new QButtonGroup(holder);
    for (const auto& c : p.choices) {
        auto* b = new QPushButton(sentence(c), holder);
        b->setProperty("segment", true);
        b->setCheckable(true);
        b->setFocusPolicy(Qt::TabFocus);
        group->addButton(b);
        line->addWidget(b);
        connect(b, &QPushButton::clicked, this, [this, p, c] { change(p, c, true); });
    }
    line->addStretch(1);
    row.show = [group, p](const ParameterValue& v) {
        for (size_t i = 0; i < p.choices.size(); ++i)
            if (p.choices[i] == std::get<std::string>(v)) group->buttons().at(int(i))->setChecked(true);
    };
    return row.field = holder;
}

QWidget* ParameterForm::pointEditor(Row& row)
{
    const Parameter& p = row.parameter;
    auto* holder = new QWidget(this);
    auto* line = new QHBoxLayout(holder);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    std::array<NumberBox*, 3> boxes;
    static const char* const edges[] = {"#E05252", "#6CBF4B", "#4C8DF0"};
    for (int i = 0; i < 3; ++i) {
        boxes[size_t(i)] = new NumberBox(holder);
        auto* box = boxes[size_t(i)];
        box->setMinimumWidth(std::max(48, box->fontMetrics().horizontalAdvance("00000") + 8));
        box->setMaximumWidth(200);
        box->setRange(std::max(p.about.min, -widest), std::min(p.about.max, widest));
        box->setSuffix(unitSuffix(p.about));
        box->setStyleSheet(QString("border-left: 2px solid %1;").arg(edges[i]));
        box->setAccessibleName(QString::fromStdString(p.about.title) + " " + "XYZ"[i]);
        line->addWidget(box, 1);
        connect(box, &NumberBox::valueChanged, this, [this, p, boxes, i](double v) {
            if (showing_) return;
            glm::dvec3 q = std::get<glm::dvec3>(valueOf(p, values_));
            q[i] = v;
            change(p, q, true);
        });
    }
    row.show = [boxes](const ParameterValue& v) {
        for (int i = 0; i < 3; ++i) boxes[size_t(i)]->setValue(std::get<glm::dvec3>(v)[i]);
    };
    row.field = boxes[0];
    return holder;
}

QWidget* ParameterForm::textEditor(Row& row)
{
    auto* edit = new QLineEdit(this);
    connect(edit, &QLineEdit::editingFinished, this, [this, p = row.parameter, edit] { change(p, edit->text().toStdString(), true); });
    row.show = [edit](const ParameterValue& v) { edit->setText(QString::fromStdString(std::get<std::string>(v))); };
    return row.field = edit;
}

// Nodes from a list; sources ("torus:radius=2") are typed.
QWidget* ParameterForm::objectEditor(Row& row)
{
    const Parameter& p = row.parameter;
    auto* box = new LateBox(this);
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->setCompleter(nullptr);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setMinimumContentsLength(8);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->installEventFilter(this);
    box->lineEdit()->setPlaceholderText("Choose the " + QString::fromStdString(p.about.title).toLower());
    const auto now = [this, p] { return QString::fromStdString(std::get<std::string>(valueOf(p, values_))); };
    box->fill = [this, box, now] {
        box->clear();
        for (const std::string& name : objects_.names ? objects_.names() : std::vector<std::string>()) box->addItem(QString::fromStdString(name));
        if (box->count() == 0 && !objects_.file) box->addItem("No other mesh is in the scene", "none");
        if (box->count() > 0) box->insertSeparator(box->count());
        if (objects_.file) box->addItem("File...", "file");
        box->setCurrentIndex(box->findText(now()));
        box->setEditText(now());
    };
    connect(box, &QComboBox::activated, this, [this, p, box, now](int i) {
        const QString what = box->itemData(i).toString(), name = box->itemText(i);
        if (what.isEmpty()) return change(p, name.toStdString(), true);
        box->setEditText(now());
        if (what == "file")
            objects_.file([form = QPointer(this), p](const std::string& made) {
                if (form) form->change(p, made, true);
            });
    });
    connect(box->lineEdit(), &QLineEdit::editingFinished, this, [this, p, box] { change(p, box->currentText().trimmed().toStdString(), true); });
    row.show = [box](const ParameterValue& v) {
        if (const QString text = QString::fromStdString(std::get<std::string>(v)); box->currentText() != text) box->setEditText(text);
    };
    return row.field = box;
}

void ParameterForm::change(const Parameter& p, ParameterValue v, bool done)
{
    if (showing_) return;
    const bool dragged = debounce_.isActive() || editing_;
    if (!done && valueOf(p, values_) == v) return;
    if (done && !dragged && valueOf(p, values_) == v && p.type != ParameterType::Integer && p.type != ParameterType::Number) return;
    values_[p.name] = v;
    refresh();
    if (!done) {
        if (!debounce_.isActive()) debounce_.start();
        return;
    }
    debounce_.stop();
    emit committed(values_, valueText(p, v));
}

void ParameterForm::setValues(const ParameterValues& values)
{
    if (editing() || values == values_) return;
    values_ = values;
    refresh();
}

void ParameterForm::refresh()
{
    showing_ = true;
    for (Row& r : rows_) {
        const ParameterValue v = valueOf(r.parameter, values_);
        r.show(v);
        const bool changed = v != r.parameter.initial;
        if (r.label->property("changed").toBool() != changed) {
            r.label->setProperty("changed", changed);
            r.label->style()->unpolish(r.label);
            r.label->style()->polish(r.label);
        }
        bool shown = true;
        if (const QString when = QString::fromStdString(r.parameter.about.when); !when.isEmpty())
            for (const Row& other : rows_)
                if (QString::fromStdString(other.parameter.name) == when.section('=', 0, 0)) {
                    const ParameterValue now = valueOf(other.parameter, values_);
                    const auto* text = std::get_if<std::string>(&now);
                    const auto* flag = std::get_if<bool>(&now);
                    const QString is = text ? QString::fromStdString(*text) : flag && *flag ? "true" : "false";
                    shown = when.section('=', 1).split('|').contains(is);
                }
        r.label->setVisible(shown);
        r.editor->setVisible(shown);
    }
    showing_ = false;
}

QSize ParameterForm::minimumSizeHint() const
{
    const QSize all = QWidget::minimumSizeHint();
    int widest = 0;
    for (const Row& r : rows_) widest = std::max(widest, r.editor->minimumSizeHint().width());
    return {widest, all.height()};
}

void ParameterForm::arrange()
{
    int label = 104, field = 0;
    for (const Row& r : rows_) {
        label = std::max(label, r.label->sizeHint().width());
        field = std::max(field, r.editor->minimumSizeHint().width());
    }
    const bool wrap = width() < label + 8 + field;
    if (wrap == wrapped_) return;
    wrapped_ = wrap;
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->setColumnMinimumWidth(0, wrap ? 0 : 104);
    for (size_t i = 0; i < rows_.size(); ++i) {
        const int r = 2 * int(i);
        grid->addWidget(rows_[i].label, wrap ? r : r + 1, 0, 1, wrap ? 2 : 1);
        grid->addWidget(rows_[i].editor, r + 1, wrap ? 0 : 1, 1, wrap ? 2 : 1);
    }
}

void ParameterForm::resizeEvent(QResizeEvent* e)
{
    QWidget::resizeEvent(e);
    arrange();
}

bool ParameterForm::eventFilter(QObject* o, QEvent* e)
{
    if (e->type() == QEvent::Wheel && !qobject_cast<QWidget*>(o)->hasFocus()) {
        e->ignore();
        return true;
    }
    if (e->type() == QEvent::MouseButtonDblClick)
        for (const Row& r : rows_)
            if (r.label == o) change(r.parameter, r.parameter.initial, true);
    return QWidget::eventFilter(o, e);
}

}  // namespace mw
