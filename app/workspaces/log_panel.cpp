#include "app/workspaces/log_panel.h"

#include "widgets/theme_style.h"

#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace halbench::app {

namespace {

constexpr int MostLines = 2000;

} // namespace

LogPanel::LogPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_text = new QPlainTextEdit(this);
    m_text->setReadOnly(true);
    m_text->setMaximumBlockCount(MostLines);
    m_text->setAccessibleName(tr("Log"));
    m_text->setToolTip(tr("Messages of board, link and window; Ctrl+C copies the selection"));
    m_text->setFont(widgets::tabularFont(font()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_text);
    connect(&m_bench.session(), &DeviceSession::message, this, &LogPanel::add);
}

QString LogPanel::text() const {
    return m_text->toPlainText();
}

void LogPanel::add(MessageLevel level, const QString& source, const QString& words) {
    const QString marks[] = {QString(), QString(), tr("Warning: "), tr("Error: ")};
    const QString time = QLocale().toString(m_bench.session().report().deviceTime_s, 'f', 2);
    m_text->appendPlainText(
        tr("%1 s  %2  %3").arg(time, 9).arg(source, marks[static_cast<int>(level)] + words));
}

} // namespace halbench::app
