#include "app/window/help/help_text.h"

#include "app/window/help/help_pages.h"

#include <QDir>
#include <QImage>
#include <QPointer>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>

namespace halbench::app {

namespace {

// A little less than a window of the help is wide; a picture is read once, before the window has its size.
constexpr int PictureWidth_letters = 100;

} // namespace

HelpText::HelpText(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
}

/// Read before it is shown: a shown document is laid out again for every word that comes, which takes seconds
/// for a long page.
void HelpText::setPage(const QString& markdown, const QString& folder, const QString& english) {
    m_folder = folder;
    m_english = english;
    auto* document = new QTextDocument(this);
    document->setDefaultFont(font());
    document->setMarkdown(markdown);
    replaceDocument(document);
}

void HelpText::setMessage(const QString& text) {
    m_english.clear();
    auto* document = new QTextDocument(this);
    document->setDefaultFont(font());
    document->setPlainText(text);
    replaceDocument(document);
}

void HelpText::replaceDocument(QTextDocument* document) {
    const QPointer<QTextDocument> before = this->document();
    setDocument(document); // deletes the first one, which it made itself
    delete before;
}

/// Headings of Markdown have no anchors in Qt.
void HelpText::showSection(const QString& anchor) {
    if (anchor.isEmpty()) {
        return;
    }
    int place = headingOf(*document(), anchor);
    if (place < 0) {
        QTextDocument english;
        english.setMarkdown(m_english);
        place = headingOf(english, anchor);
    }
    const std::vector<QTextBlock> headings = headingsOf(*document());
    if (place >= 0 && place < static_cast<int>(headings.size())) {
        setTextCursor(QTextCursor(document()->lastBlock())); // so that the heading comes to the top
        setTextCursor(QTextCursor(headings[static_cast<std::size_t>(place)]));
    }
}

QVariant HelpText::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource) {
        return {};
    }
    QImage picture(QDir::cleanPath(m_folder + name.path()));
    const qreal scale = devicePixelRatioF();
    const int most = static_cast<int>(scale * PictureWidth_letters * fontMetrics().averageCharWidth());
    if (picture.width() > most) {
        picture = picture.scaledToWidth(most, Qt::SmoothTransformation);
    }
    picture.setDevicePixelRatio(scale);
    return picture;
}

} // namespace halbench::app
