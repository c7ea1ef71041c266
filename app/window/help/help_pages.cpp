#include "app/window/help/help_pages.h"

#include <QFile>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>

#include <algorithm>

/// A static library's resources are linked only when asked for by name.
static void initialiseHelp() {
    Q_INIT_RESOURCE(help);
}

namespace halbench::app {

namespace {

/// Of every language's letters, as the readers of Markdown make it.
QString anchorOf(const QString& heading) {
    static const QRegularExpression dropped(QStringLiteral("[^\\w\\- ]"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    QString anchor = heading.toLower();
    anchor.remove(dropped);
    return anchor.replace(QLatin1Char(' '), QLatin1Char('-'));
}

} // namespace

QString helpFolder(const QString& language) {
    return language == QLatin1String("en") ? QStringLiteral(":/help/") : ":/help/" + language + '/';
}

QString helpText(const QString& page, const QString& language) {
    initialiseHelp();
    QFile file(helpFolder(language) + page);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

std::vector<QTextBlock> headingsOf(const QTextDocument& page) {
    std::vector<QTextBlock> headings;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0) {
            headings.push_back(block);
        }
    }
    return headings;
}

int headingOf(const QTextDocument& page, const QString& anchor) {
    const std::vector<QTextBlock> headings = headingsOf(page);
    const auto found = std::find_if(headings.begin(), headings.end(), [&](const QTextBlock& heading) {
        return anchorOf(heading.text()) == anchor;
    });
    return found == headings.end() ? -1 : static_cast<int>(found - headings.begin());
}

} // namespace halbench::app
