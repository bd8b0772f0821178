#include "ui/panels/decoded_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageReader>
#include <QPointer>
#include <QThreadPool>
#include <list>

namespace mw {
namespace {

constexpr qint64 mostPixels = qint64(16384) * 16384;

struct Known {
    std::shared_ptr<const std::vector<uint8_t>> bytes;
    int side;
    QImage picture;
    bool done;
};
std::list<Known>& known()
{
    static std::list<Known> all;  // newest first; of the window's thread
    return all;
}

QImage decode(const std::vector<uint8_t>& bytes, int side)
{
    QByteArray data = QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    QBuffer buffer(&data);
    QImageReader reader(&buffer);
    const QSize size = reader.size();
    if (size.isEmpty() || qint64(size.width()) * size.height() > mostPixels) return {};
    if (size.width() > side || size.height() > side) reader.setScaledSize(size.scaled(side, side, Qt::KeepAspectRatio).expandedTo({1, 1}));
    return reader.read();
}

}  // namespace

QSize pictureSize(const Image& image)
{
    if (!image.bytes) return {};
    QByteArray data = QByteArray::fromRawData(reinterpret_cast<const char*>(image.bytes->data()), qsizetype(image.bytes->size()));
    QBuffer buffer(&data);
    return QImageReader(&buffer).size();
}

QImage decodedPicture(const Image& image, int side, QObject* receiver, std::function<void()> ready)
{
    if (!image.bytes) return {};
    for (const Known& k : known())
        if (k.bytes == image.bytes && k.side == side && k.done) return k.picture;
    known().push_front({image.bytes, side, {}, false});
    if (known().size() > 48) known().pop_back();
    QThreadPool::globalInstance()->start([bytes = image.bytes, side, to = QPointer<QObject>(receiver), ready = std::move(ready)] {
        QImage picture = decode(*bytes, side);
        QMetaObject::invokeMethod(qApp, [bytes, side, to, ready, picture] {
            for (Known& k : known())
                if (k.bytes == bytes && k.side == side) k.picture = picture, k.done = true;
            if (to) ready();
        });
    });
    return {};
}

}  // namespace mw
