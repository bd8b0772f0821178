// The drawing of the texture coordinates: pan by dragging, zoom to the pointer, click to select.
#pragma once
#include <QThreadPool>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "ui/panels/uv_picture.h"
#include "ui/view_state.h"

namespace mw {

class UvCanvas : public QWidget {
    Q_OBJECT

public:
    explicit UvCanvas(QWidget* parent);
    ~UvCanvas() override;
    void setSubject(std::shared_ptr<const UvSubject> subject);  ///< fits it when it is another mesh's
    void setOptions(UvOptions options);
    const UvOptions& options() const { return options_; }
    void setPickKind(PickKind kind) { pickKind_ = kind; }
    void fit();  ///< all of 0 to 1 and of the layout
    const UvView& view() const { return view_; }
    glm::dvec2 coordinatesAt(QPointF p) const;
    QPointF placeOf(glm::dvec2 t) const;
    bool upToDate() const { return !running_ && !again_.isActive(); }

signals:
    /// Clicked on; `kind` says of what; empty: beside everything. Edges are pairs.
    void picked(mw::ElementKind kind, std::vector<uint32_t> indices, Qt::KeyboardModifiers modifiers);
    void pointed(std::optional<glm::dvec2> coordinates);

protected:
    void paintEvent(QPaintEvent* e) override;
    void resizeEvent(QResizeEvent* e) override;
    void wheelEvent(QWheelEvent* e) override;
    void mousePressEvent(QMouseEvent* e) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void leaveEvent(QEvent* e) override;
    void keyPressEvent(QKeyEvent* e) override;

private:
    void viewChanged();
    void renderSoon(int milliseconds);
    void render();
    void zoom(double factor, QPointF at);
    void pick(QPointF at, Qt::KeyboardModifiers modifiers);

    std::shared_ptr<const UvSubject> subject_;
    UvOptions options_;
    UvView view_;
    PickKind pickKind_ = PickKind::Object;
    QImage picture_;   // the last one made
    UvView pictured_;  // the view it was made for
    QSize picturedSize_;
    QTimer again_;
    QThreadPool pool_;
    std::shared_ptr<std::atomic<bool>> stop_;
    bool running_ = false, fitted_ = false;
    QPointF press_, last_, lastClick_{-100, -100};
    size_t lastChoice_ = 0;
    bool moved_ = false;
};

}  // namespace mw
