#include "ui/banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "ui/theme.h"
#include "ui/words.h"

namespace mw {

Banner::Banner(QWidget* parent) : QWidget(parent)
{
    setObjectName("banner");
    setAttribute(Qt::WA_StyledBackground);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(10, 5, 6, 5);
    box->setSpacing(4);
    line_ = new QHBoxLayout;
    icon_ = new IconLabel("ok", &Tokens::success, this);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setFocusPolicy(Qt::NoFocus);
    more_ = new QPushButton(this);
    more_->setFocusPolicy(Qt::TabFocus);
    more_->setToolTip("What was odd about the file, and what was done about it");
    auto* close = new QToolButton(this);
    close->setIcon(mw::icon("x", tokens().text2));
    close->setAccessibleName("Close message");
    close->setToolTip("Close this message");
    close->setFocusPolicy(Qt::TabFocus);
    list_ = new QLabel(this);
    list_->setWordWrap(true);
    list_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setProperty("secondary", true);
    line_->addWidget(icon_);
    line_->addWidget(text_, 1);
    line_->addWidget(more_);
    line_->addWidget(close);
    box->addLayout(line_);
    box->addWidget(list_);
    timer_ = new QTimer(this);
    timer_->setSingleShot(true);
    connect(timer_, &QTimer::timeout, this, &QWidget::hide);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(more_, &QPushButton::clicked, this, [this] { list_->setVisible(!list_->isVisible()); });
    hide();
}

QString Banner::text() const
{
    return text_->text();
}

void Banner::show(const QString& text, const char* iconName, QColor Tokens::*color)
{
    icon_->set(iconName, color);
    for (QPushButton* b : std::exchange(offers_, {})) b->deleteLater();
    text_->setText(text);
    list_->hide();
    more_->hide();
    timer_->stop();
    QWidget::show();
}

void Banner::notice(const QString& text, const std::vector<Warning>& warnings)
{
    sinceTrouble_.invalidate();
    show(text, warnings.empty() ? "ok" : "warning", warnings.empty() ? &Tokens::success : &Tokens::warning);
    if (warnings.empty()) return timer_->start(6000);
    more_->setText(counted(warnings.size(), "warning", "warnings") + ": show");
    more_->show();
    QStringList lines;
    for (size_t i = 0; i < warnings.size() && i < 12; ++i) lines << "· " + QString::fromStdString(warnings[i].text);
    if (warnings.size() > 12) lines << QString("and %1 more").arg(warnings.size() - 12);
    list_->setText(lines.join('\n'));
}

void Banner::trouble(const QString& text)
{
    const bool more = isVisible() && sinceTrouble_.isValid() && sinceTrouble_.elapsed() < 1500 && text_->text().count('\n') < 4;
    show(more ? text_->text() + '\n' + text : text, "error", &Tokens::error);
    sinceTrouble_.start();
}

void Banner::ask(const QString& text)
{
    show(text, "help", &Tokens::accentText);
    sinceTrouble_.invalidate();
}

void Banner::offer(const QString& verb, const QString& tip, std::function<void()> run)
{
    auto* b = new QPushButton(verb, this);
    b->setFocusPolicy(Qt::TabFocus);
    b->setToolTip(tip);
    connect(b, &QPushButton::clicked, this, [this, run = std::move(run)] {
        timer_->start(15000);  // time to read what is asked, and then it goes
        run();
    });
    line_->insertWidget(line_->indexOf(more_), b);
    offers_ << b;
    b->show();
    if (timer_->isActive()) timer_->start(15000);  // time to read, and to reach it
}

}  // namespace mw
