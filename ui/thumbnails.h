// Small pictures of recent files and of samples, made once and kept in the user's cache folder.
#pragma once
#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QStringList>

#include "core/scene/scene.h"
#include "ui/session.h"

namespace mw {

namespace thumbnails {
inline constexpr int width = 96, height = 72;  ///< logical pixels; kept at twice that
QPixmap kept(const QString& key);              ///< of a file (its whole path) or "sample:ID"; null when there is none
void keep(const QString& key, const QImage& picture);
}  // namespace thumbnails

/// Draws the pictures of scenes that are on no screen: the scene is made by a worker, drawn between events.
class ThumbnailMaker : public QObject {
    Q_OBJECT

public:
    explicit ThumbnailMaker(Session& session, QObject* parent);
    ~ThumbnailMaker() override;
    /// Of every sample that has none yet.
    void makeSamples();

signals:
    void made(const QString& key);

private:
    struct Drawing;
    void draw(const QString& key, const Scene& scene);
    Session& session_;
    std::unique_ptr<Drawing> drawing_;
};

}  // namespace mw
