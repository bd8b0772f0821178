// The views side by side: one, two or four, each with a header of its own when there are several. The first is never made again.
#pragma once
#include <QFrame>
#include <functional>
#include <memory>
#include <vector>

#include "ui/session.h"

class QGridLayout;
class QMenu;

namespace mw {

class HeatService;
class Viewport;

class ViewArea : public QWidget {
    Q_OBJECT

public:
    explicit ViewArea(Session& session, QWidget* parent = nullptr);
    ~ViewArea() override;

    int count() const { return int(panes_.size()); }
    Viewport& at(int view) const { return *panes_[size_t(view)].view; }
    Viewport& first() const { return at(0); }
    Viewport& active() const;  ///< the one used last
    void split(int count);     ///< 1, 2 or 4; those that go take their settings with them
    /// Two views: the result on the left, the base of this mesh on the right.
    void compareWithBase(MeshId mesh);
    /// Two or four linked views: the result, and what the last modifier could be in place of it, each coloured as the active view is.
    void compareVariants(MeshId mesh);

    void setContextMenu(QMenu* menu);
    /// Who makes the header of a view while there are several, and what else it carries (HUDs).
    void setFurnisher(std::function<QWidget*(Viewport&, QWidget* parent)> header, std::function<void(Viewport&)> huds);

signals:
    void hint(const QString& text);
    void failed(const QString& text);

private:
    struct Pane {
        QFrame* frame;
        QWidget* header;  // null: none yet
        Viewport* view;
    };
    void add();
    void arrange();
    void refresh();       // which one is active
    void keepVariants();  // those that are shown, and no other

    Session& session_;
    std::shared_ptr<HeatService> heats_;
    std::shared_ptr<void> subscription_;
    std::vector<Pane> panes_;
    QGridLayout* grid_;
    QMenu* menu_ = nullptr;
    std::function<QWidget*(Viewport&, QWidget*)> header_;
    std::function<void(Viewport&)> huds_;
};

}  // namespace mw
