// See lesson_desk.h.
#include "ui/panels/lesson_desk.h"

#include <QPointer>
#include <QSettings>
#include <glm/trigonometric.hpp>

#include "core/catalog/lesson_scene.h"
#include "core/io/io.h"

namespace mw {

LessonDesk& LessonDesk::of(Session& session)
{
    if (auto* desk = session.steps.findChild<LessonDesk*>({}, Qt::FindDirectChildrenOnly)) return *desk;
    return *new LessonDesk(session, &session.steps);
}

LessonDesk::LessonDesk(const Session& session, QObject* parent) : QObject(parent), session_(session)
{
    connect(&session_.steps, &StepSession::changed, this, &LessonDesk::stepChanged);
    subscription_ = session_.document.subscribe([this](const Change&) { documentChanged(); });
}

void LessonDesk::show(const Lesson* lesson)
{
    if (lesson_ == lesson) return;
    lesson_ = lesson;
    emit changed();
}

void LessonDesk::load(const Lesson& lesson)
{
    if (loading_) session_.jobs.cancel(job_);
    lesson_ = &lesson;
    loading_ = true;
    error_.clear();
    QPointer<LessonDesk> self(this);
    job_ = session_.jobs.start(
        tr("Lesson: %1").arg(QString::fromStdString(lesson.title)),
        [self, &lesson](Progress& p) -> std::function<void()> {
            const Value subject = lessonSubject(lesson, &p);
            return [self, &lesson, subject] {
                if (self && self->lesson_ == &lesson) self->open(lesson, subject);
            };
        },
        [self](const QString& why) {
            if (!self) return;
            self->loading_ = false;
            self->error_ = why;
            emit self->changed();
        });
    emit changed();
}

void LessonDesk::open(const Lesson& lesson, const Value& subject)
{
    loading_ = false;
    const Operation* op = findOperation(lesson.id);
    if (const Mesh* mesh = std::get_if<Mesh>(&subject)) {
        openScene(lesson, op, *mesh);
    } else if (op) {  // a lab: the scene stays as it is, out of sight
        loaded_ = &lesson;
        session_.steps.open(*op, {}, subject, parsed(op->parameters, lesson.scene.parameters));
    }
    emit changed();
}

void LessonDesk::openScene(const Lesson& lesson, const Operation* op, const Mesh& mesh)
{
    Document& document = session_.document;
    if (!before_ || document.snapshot() != lessonScene_) before_ = document.snapshot();
    session_.steps.close();
    Scene scene = sceneOf(mesh, lesson.title);
    const NodeId node = scene.roots().front();
    document.commit("Lesson: " + lesson.title, std::move(scene), {{node}, {}, {}}, {{"lesson", {{"lesson", lesson.id}}}});
    lessonScene_ = document.snapshot();
    loaded_ = &lesson;
    session_.view.camera.azimuth = glm::radians(lesson.scene.azimuth);
    session_.view.camera.elevation = glm::radians(lesson.scene.elevation);
    session_.view.touch();
    session_.view.frameNodes({});
    if (op) session_.steps.open(*op, node, Value{mesh}, parsed(op->parameters, lesson.scene.parameters));
}

void LessonDesk::backToMyScene()
{
    if (!before_) return;
    session_.steps.close();
    Document& document = session_.document;
    const std::shared_ptr<const Scene> mine = std::move(before_);
    before_.reset();
    loaded_ = nullptr;
    const auto& history = document.history();
    for (size_t i = history.size(); i-- > 0;)
        if (history[i].scene == mine) {
            document.goTo(i);
            emit changed();
            return;
        }
    document.commit("Back to my scene", *mine);
    emit changed();
}

// Undo or opening a file may have left the lesson's scene behind.
void LessonDesk::documentChanged()
{
    if (!before_ || session_.document.snapshot() == lessonScene_) return;
    if (session_.document.snapshot() == before_ || session_.document.history().size() <= 1) {
        before_.reset();
        loaded_ = nullptr;
        emit changed();
    }
}

void LessonDesk::stepChanged()
{
    if (!loaded_ || !session_.steps.isOpen() || !session_.steps.atEnd() || session_.steps.operation()->id != loaded_->id || done(*loaded_)) return;
    QSettings settings;
    QStringList ids = settings.value("lessons/done").toStringList();
    ids << QString::fromStdString(loaded_->id);
    settings.setValue("lessons/done", ids);
    emit changed();
}

bool LessonDesk::done(const Lesson& lesson) const
{
    return QSettings().value("lessons/done").toStringList().contains(QString::fromStdString(lesson.id));
}

}  // namespace mw
