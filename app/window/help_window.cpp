#include "app/window/help_window.h"

#include "widgets/stop_button.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QFile>
#include <QHBoxLayout>
#include <QPointer>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolButton>
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

namespace {

/// As links in Markdown name a heading: "6.2 Two currents" is "62-two-currents".
QString anchorOf(const QString& heading) {
    QString anchor = heading.toLower();
    anchor.remove(QRegularExpression(QStringLiteral("[^\\w\\- ]")));
    return anchor.replace(QLatin1Char(' '), QLatin1Char('-'));
}

} // namespace

HelpWindow::HelpWindow(const QString& page, QWidget* parent) : QWidget(parent, Qt::Window) {
    setWindowTitle(tr("Halbench help"));
    new QVBoxLayout(this);
    layout()->setContentsMargins(0, 0, 0, 0);
    layout()->setSpacing(0);
    buildBar();
    m_text = new QTextBrowser(this);
    m_text->setOpenLinks(false);
    m_text->setAccessibleName(tr("Help page"));
    m_text->setToolTip(tr("Alt+Left goes back"));
    layout()->addWidget(m_text);
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
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
    m_back->setToolTip(tr("The page before (Alt+Left)"));
    m_back->setEnabled(false);
    addAction(m_back);
    connect(m_back, &QAction::triggered, this, &HelpWindow::goBack);
    auto* back = new QToolButton(this);
    back->setDefaultAction(m_back);
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, this);
    connect(stop, &widgets::StopButton::stopRequested, this, &HelpWindow::stopRequested);
    row->addWidget(back);
    row->addStretch(1);
    row->addWidget(stop);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void HelpWindow::openPage(const QString& address) {
    const QString page = address.section(QLatin1Char('#'), 0, 0);
    if (!page.isEmpty()) {
        m_visited << page;
        showPage(page);
    }
    showSection(address.section(QLatin1Char('#'), 1));
}

/// Headings of Markdown have no anchors in Qt.
void HelpWindow::showSection(const QString& anchor) {
    const QTextDocument& document = *m_text->document();
    for (QTextBlock block = document.begin(); !anchor.isEmpty() && block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) {
            m_text->setTextCursor(QTextCursor(document.lastBlock())); // so that the heading comes to the top
            m_text->setTextCursor(QTextCursor(block));
        }
    }
}

void HelpWindow::goBack() {
    m_visited.removeLast();
    showPage(m_visited.last());
}

void HelpWindow::showPage(const QString& page) {
    m_back->setEnabled(m_visited.size() > 1);
    const QString text = helpText(page);
    // Read before it is shown: a shown document is laid out again for every word that comes, which takes
    // seconds for a long page.
    auto* document = new QTextDocument(m_text);
    document->setDefaultFont(m_text->font());
    if (text.isEmpty()) {
        document->setPlainText(tr("There is no help page '%1' in this program.").arg(page));
    } else {
        document->setMarkdown(text);
    }
    const QPointer<QTextDocument> before = m_text->document();
    m_text->setDocument(document); // deletes the first one, which it made itself
    delete before;
}

} // namespace halbench::app
