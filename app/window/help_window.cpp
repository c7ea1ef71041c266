#include "app/window/help_window.h"

#include <QFile>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

/// A static library's resources are linked only when asked for by name.
static void initialiseHelp() {
    Q_INIT_RESOURCE(help);
}

namespace halbench::app {

QString helpText(const QString& page) {
    initialiseHelp();
    QFile file(":/help/" + page);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

HelpWindow::HelpWindow(const QString& page, QWidget* parent) : QWidget(parent, Qt::Window) {
    setWindowTitle(tr("Halbench help"));
    m_text = new QTextBrowser(this);
    m_text->setOpenLinks(false);
    m_text->setAccessibleName(tr("Help page"));
    m_text->setToolTip(tr("Alt+Left goes back"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_text);
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        if (link.isRelative() && !link.path().isEmpty()) {
            openPage(link.path());
        }
        if (link.hasFragment()) {
            m_text->scrollToAnchor(link.fragment());
        }
    });
    resize(fontMetrics().averageCharWidth() * 110, fontMetrics().height() * 45);
    openPage(page);
}

void HelpWindow::openPage(const QString& page) {
    const QString text = helpText(page);
    if (text.isEmpty()) {
        m_text->setPlainText(tr("There is no help page '%1' in this program.").arg(page));
    } else {
        m_text->setMarkdown(text);
    }
}

} // namespace halbench::app
