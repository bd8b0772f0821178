// A form made from parameter descriptions: nobody writes a widget for a number. Live while it is changed, one commit when it is done.
#pragma once
#include <QTimer>
#include <QWidget>
#include <functional>

#include "core/catalog/parameters.h"
#include "ui/number_box.h"

class QGridLayout;
class QLabel;
class QSlider;

namespace mw {

/// What a parameter of type object can be set to; whoever makes a form for such parameters says it.
struct ObjectChoices {
    std::function<std::vector<std::string>()> names;  ///< nodes that show a mesh; asked each time the list opens
    /// Asks for a file and makes a node of it; `then` gets its name. Without it there is no "File...".
    std::function<void(std::function<void(const std::string& name)> then)> file;
};

class ParameterForm : public QWidget {
    Q_OBJECT

public:
    ParameterForm(std::vector<Parameter> parameters, ParameterValues values, QWidget* parent = nullptr);
    void setValues(const ParameterValues& values);  ///< from outside: undo, another selection; not while something is being dragged
    const ParameterValues& values() const { return values_; }
    bool editing() const { return editing_ || debounce_.isActive(); }
    QSize minimumSizeHint() const override;
    void setObjects(ObjectChoices choices) { objects_ = std::move(choices); }
    QWidget* field(const QString& name) const;  ///< the spin box, check box, combo or text field of a parameter

signals:
    void edited(const mw::ParameterValues& values);                          ///< on the way, at most every 120 ms
    void committed(const mw::ParameterValues& values, const QString& what);  ///< done: "faces 20,000"

private:
    struct Row {
        Parameter parameter;
        QLabel* label = nullptr;
        QWidget *editor = nullptr, *field = nullptr;
        std::function<void(const ParameterValue&)> show;
    };
    void makeRow(Row& row);
    QWidget* numberEditor(Row& row);
    QWidget* choiceEditor(Row& row);
    QWidget* pointEditor(Row& row);
    QWidget* textEditor(Row& row);
    QWidget* objectEditor(Row& row);
    void change(const Parameter& p, ParameterValue v, bool done);
    void refresh();
    void arrange();
    void resizeEvent(QResizeEvent* e) override;
    bool eventFilter(QObject* o, QEvent* e) override;

    std::vector<Row> rows_;
    ObjectChoices objects_;
    ParameterValues values_;
    QTimer debounce_;
    bool editing_ = false, showing_ = false, wrapped_ = false;
};

/// "faces 20,000": for the name of a history entry.
QString valueText(const Parameter& p, const ParameterValue& v);

}  // namespace mw
