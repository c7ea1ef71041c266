#pragma once

#include <QString>

#include <string>

namespace halbench::widgets {

/// What the layers below Qt say (messages and hints of errors, findings, a board's own descriptions), in the
/// user's language. Those layers speak English, on the command line and in files; the English text is the key
/// here: it is matched against the phrases of the sources ("the device has no parameter '{}'"), the phrase is
/// translated, and what was filled in is put into the translation: numbers with the decimal sign of the
/// language, what stands in quotes as it is, the rest looked up in turn. So an answer of a worker thread, a
/// finding read from an old file and the text of a board need nothing but their English words. Of several
/// sentences each is looked up by itself, and one behind its place ("motor.toml:3:1: ...") without it. What
/// no phrase matches stays as it is: the words of an unknown board.
QString inWords(const QString& english);
QString inWords(const std::string& english);

/// Whether a phrase matches the text, or each of its sentences.
bool isInPhrasebook(const QString& english);

} // namespace halbench::widgets
