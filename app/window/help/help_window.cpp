#include "app/window/help/help_window.h"

#include "app/window/help/help_pages.h"
#include "app/window/help/help_text.h"
#include "app/window/preferences/language.h"
#include "widgets/controls/stop_button.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QShowEvent>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

HelpWindow::HelpWindow(const QString& page, QWidget* parent)
    : QWidget(parent, Qt::Window), m_language(spokenLanguage()) {
    setWindowTitle(tr("Halbench help"));
    new QVBoxLayout(this);
    layout()->setContentsMargins(0, 0, 0, 0);
    layout()->setSpacing(0);
    buildBar();
    m_text = new HelpText(this);
    m_text->setAccessibleName(tr("Help page"));
    m_text->setToolTip(tr("Alt+Left goes back"));
    layout()->addWidget(m_text);
    m_text->setFocus(); // arrow keys scroll at once
    connect(m_text, &HelpText::anchorClicked, this, [this](const QUrl& link) {
        if (link.isRelative()) {
            openPage(link.toString());
        }
    });
    resize(fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 45);
    openPage(page);
}

void HelpWindow::buildBar() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px, widgets::PanelMargin_px,
                            widgets::GridStep_px);
    m_back = new QAction(tr("Back"), this);
    m_back->setShortcut(QKeySequence("Alt+Left"));
    m_back->setToolTip(tr("Previous page (Alt+Left)"));
    m_back->setEnabled(false);
    addAction(m_back);
    connect(m_back, &QAction::triggered, this, &HelpWindow::goBack);
    auto* back = new QToolButton(this);
    back->setDefaultAction(m_back);
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, this);
    connect(stop, &widgets::StopButton::stopRequested, this, &HelpWindow::stopRequested);
    row->addWidget(back);
    row->addWidget(makeClose());
    row->addStretch(1);
    row->addWidget(stop);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

QToolButton* HelpWindow::makeClose() {
    auto* action = new QAction(tr("Close"), this);
    action->setShortcut(QKeySequence("Ctrl+W"));
    action->setToolTip(tr("Close the help (Ctrl+W; Esc only when disarmed and idle)"));
    addAction(action);
    connect(action, &QAction::triggered, this, &QWidget::close);
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    return button;
}

void HelpWindow::setNothingToStop(std::function<bool()> isNothingToStop) {
    m_isNothingToStop = std::move(isNothingToStop);
}

/// Where there may be something to stop, Esc has stopped it and this page stays.
void HelpWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_isNothingToStop && m_isNothingToStop()) {
        close();
        return;
    }
    QWidget::keyPressEvent(event);
}

void HelpWindow::openPage(const QString& address) {
    const QString page = address.section(QLatin1Char('#'), 0, 0).section(QLatin1Char('/'), -1);
    m_section = address.section(QLatin1Char('#'), 1);
    if (!page.isEmpty()) {
        m_visited << page;
        showPage(page);
    }
    m_text->showSection(m_section);
}

/// What was brought to the top of a window that had no size yet is elsewhere now.
void HelpWindow::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!event->spontaneous()) {
        m_text->showSection(m_section);
    }
}

void HelpWindow::goBack() {
    m_visited.removeLast();
    m_section.clear();
    showPage(m_visited.last());
}

void HelpWindow::showPage(const QString& page) {
    m_back->setEnabled(m_visited.size() > 1);
    const QString english = helpText(page);
    const QString text = helpText(page, m_language);
    if (english.isEmpty()) {
        m_text->setMessage(tr("Help page '%1' not found.").arg(page));
    } else if (text.isEmpty()) {
        const QString note = tr("This page is available in English only.");
        m_text->setPage('*' + note + "*\n\n" + english, helpFolder("en"), english);
    } else {
        m_text->setPage(text, helpFolder(m_language), english);
    }
}

} // namespace halbench::app
