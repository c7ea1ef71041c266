#include "app/workspaces/log_panel.h"

#include "widgets/log_view.h"
#include "widgets/phrasebook.h"

#include <QVBoxLayout>

namespace halbench::app {

namespace {

widgets::LogLevel levelOf(MessageLevel level) {
    switch (level) {
    case MessageLevel::Debug:
        return widgets::LogLevel::Debug;
    case MessageLevel::Warning:
        return widgets::LogLevel::Warning;
    case MessageLevel::Error:
        return widgets::LogLevel::Error;
    case MessageLevel::Info:
        break;
    }
    return widgets::LogLevel::Information;
}

} // namespace

LogPanel::LogPanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_view(new widgets::LogView(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    connect(&m_bench.session(), &DeviceSession::message, this, &LogPanel::add);
}

QString LogPanel::text() const {
    return m_view->text();
}

void LogPanel::add(MessageLevel level, const QString& source, const QString& words) {
    m_view->append(
        {{m_bench.session().report().deviceTime_s, levelOf(level), source, widgets::inWords(words)}});
}

} // namespace halbench::app
