#pragma once

#include <QString>

#include <vector>

class QTextBlock;
class QTextDocument;

namespace halbench::app {

/// Markdown of a page of resources/help in a language of the window; empty when there is none of that name in
/// it. English has every page, the other languages those of the window: resources/help/<language>/PAGE.
QString helpText(const QString& page, const QString& language = QStringLiteral("en"));

/// Folder of resources/help/PAGE in that language, as compiled in.
QString helpFolder(const QString& language);

/// The headings of a page in their order, which is the same in every language.
std::vector<QTextBlock> headingsOf(const QTextDocument& page);

/// The place of the heading that a link names: "6.2 Two currents" is "62-two-currents". -1: there is none.
int headingOf(const QTextDocument& page, const QString& anchor);

} // namespace halbench::app
