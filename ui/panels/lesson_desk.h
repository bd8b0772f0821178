// The lesson that is open, for the two panels that show lessons; and the scene that waits meanwhile.
#pragma once
#include <QObject>
#include <QString>
#include <memory>

#include "core/catalog/lesson.h"
#include "ui/session.h"

namespace mw {

class LessonDesk : public QObject {
    Q_OBJECT

public:
    /// One a session; made when first asked for.
    static LessonDesk& of(Session& session);

    /// The lesson whose text is shown. Null: none.
    const Lesson* lesson() const { return lesson_; }
    void show(const Lesson* lesson);
    /// Makes its scene (a job), keeps what was open, and begins stepping.
    void load(const Lesson& lesson);
    bool loading() const { return loading_; }
    const Lesson* loaded() const { return loaded_; }  ///< whose scene is open
    const QString& error() const { return error_; }

    bool canGoBack() const { return before_ != nullptr; }
    void backToMyScene();

    bool done(const Lesson& lesson) const;  ///< it was stepped to its end once

signals:
    void changed();

private:
    LessonDesk(const Session& session, QObject* parent);
    void open(const Lesson& lesson, const Value& subject);
    void openScene(const Lesson& lesson, const Operation* op, const Mesh& mesh);
    void stepChanged();
    void documentChanged();

    Session session_;
    std::shared_ptr<void> subscription_;
    const Lesson *lesson_ = nullptr, *loaded_ = nullptr;
    std::shared_ptr<const Scene> before_, lessonScene_;
    QString error_;
    quint64 job_ = 0;
    bool loading_ = false;
};

}  // namespace mw
