#include "widgets/language/phrasebook.h"

#include "widgets/language/display_units.h"
#include "widgets/language/phrases.h"
#include "widgets/language/window_terms.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

namespace halbench::widgets {

namespace {

constexpr char Context[] = "Phrases";

struct Pattern {
    const char* phrase;
    QStringList pieces; ///< what stands between the {}
    int letters = 0;    ///< of the pieces: the more, the more telling
};

struct Phrasebook {
    QHash<QString, const char*> whole; ///< phrases into which nothing is filled
    std::vector<Pattern> patterns;     ///< the most telling first
};

Phrasebook readTables() {
    Phrasebook book;
    for (const auto& table : {phrasesOfBoards(), phrasesOfSimulation(), phrasesOfControl(), phrasesOfLines(),
                              phrasesOfDevices(), phrasesOfTuning(), phrasesOfReferences(),
                              phrasesOfProcedures(), phrasesOfActuators(), phrasesOfFiles()}) {
        for (const char* phrase : table) {
            const QStringList pieces = QString::fromUtf8(phrase).split(QStringLiteral("{}"));
            if (pieces.size() == 1) {
                book.whole.insert(pieces.front(), phrase);
            } else {
                book.patterns.push_back({phrase, pieces, pieces.join(QString()).size()});
            }
        }
    }
    std::stable_sort(book.patterns.begin(), book.patterns.end(),
                     [](const Pattern& one, const Pattern& other) { return one.letters > other.letters; });
    return book;
}

const Phrasebook& phrasebook() {
    static const Phrasebook book = readTables();
    return book;
}

/// What stands in the place of each {}, as short as possible; nothing when the text is another one.
std::optional<QStringList> fillings(const Pattern& pattern, const QString& text) {
    const QString& last = pattern.pieces.back();
    const int end = text.size() - last.size();
    if (!text.startsWith(pattern.pieces.front()) || !text.endsWith(last)) {
        return std::nullopt;
    }
    QStringList found;
    int at = pattern.pieces.front().size();
    for (int piece = 1; piece < pattern.pieces.size(); ++piece) {
        const bool isLast = piece + 1 == pattern.pieces.size();
        const int next = isLast ? end : text.indexOf(pattern.pieces[piece], at);
        if (next < at) {
            return std::nullopt;
        }
        found << text.mid(at, next - at);
        at = next + pattern.pieces[piece].size();
    }
    return found;
}

QString translated(const char* phrase) {
    return QCoreApplication::translate(Context, phrase);
}

std::optional<QString> sentence(const QString& english);

bool isQuoted(const Pattern& pattern, int place) {
    const QString& before = pattern.pieces[place];
    const QString& after = pattern.pieces[place + 1];
    return !before.isEmpty() && !after.isEmpty() && before.back() == after.front() &&
           (after.front() == QLatin1Char('\'') || after.front() == QLatin1Char('"'));
}

/// "alpha 40, ... deg; alpha -20, ... deg": a list of texts that are all known.
std::optional<QString> listed(const QString& english) {
    const QString mark = QStringLiteral("; ");
    QStringList parts = english.split(mark);
    for (QString& part : parts) {
        const std::optional<QString> found = parts.size() > 1 ? sentence(part) : std::nullopt;
        if (!found) {
            return std::nullopt;
        }
        part = *found;
    }
    return parts.join(mark);
}

QString filling(const QString& english) {
    static const QRegularExpression number(QStringLiteral("^-?[0-9]+\\.[0-9]+(e[-+]?[0-9]+)?$"));
    if (number.match(english).hasMatch()) {
        QString local = tidyExponent(english);
        return local.replace(QLatin1Char('.'), QLocale().decimalPoint());
    }
    if (const std::optional<QString> list = listed(english)) {
        return *list;
    }
    return sentence(english).value_or(english);
}

/// Puts the fillings where the translation has {}, or {0}, {1} where its order is another.
QString filledIn(const QString& translation, const QStringList& words) {
    static const QRegularExpression hole(QStringLiteral("\\{([0-9]*)\\}"));
    QString text;
    int at = 0;
    int next = 0;
    for (auto holes = hole.globalMatch(translation); holes.hasNext();) {
        const QRegularExpressionMatch match = holes.next();
        const int place = match.captured(1).isEmpty() ? next++ : match.captured(1).toInt();
        text += translation.mid(at, match.capturedStart() - at) + words.value(place);
        at = match.capturedEnd();
    }
    return text + translation.mid(at);
}

/// "motor.toml:3:1: unknown key ...": where it was stays, what it is is looked up. "3 of 9 rows are missing:
/// the line ...": what happened, and why.
std::optional<QString> afterItsPlace(const QString& english) {
    const int colon = english.indexOf(QStringLiteral(": "));
    const auto what = colon > 0 ? sentence(english.mid(colon + 2)) : std::nullopt;
    if (!what) {
        return std::nullopt;
    }
    const QString before = english.left(colon);
    return sentence(before).value_or(before) + english.mid(colon, 2) + *what;
}

/// "install the rules ..., or join the group ...": a sentence and what was added to it.
std::optional<QString> continued(const QString& english) {
    const QString comma = QStringLiteral(", ");
    for (int at = english.indexOf(comma); at > 0; at = english.indexOf(comma, at + 1)) {
        const char* phrase = phrasebook().whole.value(english.left(at), nullptr);
        const auto added = phrase != nullptr ? sentence(english.mid(at)) : std::nullopt;
        if (added) {
            return translated(phrase) + *added;
        }
    }
    return std::nullopt;
}

std::optional<QString> sentence(const QString& english) {
    const Phrasebook& book = phrasebook();
    if (const char* phrase = book.whole.value(english, nullptr)) {
        return translated(phrase);
    }
    for (const Pattern& pattern : book.patterns) {
        if (const auto found = fillings(pattern, english)) {
            QStringList words;
            for (int place = 0; place < found->size(); ++place) {
                words << (isQuoted(pattern, place) ? found->at(place) : filling(found->at(place)));
            }
            return filledIn(translated(pattern.phrase), words);
        }
    }
    const auto placed = afterItsPlace(english);
    return placed ? placed : continued(english);
}

/// A phrase or the beginning of a text that is one, with what is left of the text; the longest beginning
/// counts, as a phrase may itself have several sentences. All but the last have lost their full stop to the
/// split.
std::optional<QStringList> sentences(const QStringList& parts) {
    for (int count = parts.size(); count > 0; --count) {
        const QString text = parts.mid(0, count).join(QStringLiteral(". "));
        const bool isLast = count == parts.size();
        std::optional<QString> found;
        if (!isLast) {
            found = sentence(text + QLatin1Char('.'));
        }
        if (found) {
            found->chop(1);
        } else {
            found = sentence(text);
        }
        if (found && isLast) {
            return QStringList(*found);
        }
        if (const auto rest = found ? sentences(parts.mid(count)) : std::nullopt) {
            return QStringList(*found) + *rest;
        }
    }
    return std::nullopt;
}

std::optional<QStringList> sentences(const QString& english) {
    return sentences(english.split(QStringLiteral(". ")));
}

/// Files are ASCII; on the screen each of these has one spelling.
QString withSigns(QString words) {
    static const std::pair<QRegularExpression, QString> signs[] = {
        {QRegularExpression(QStringLiteral("(?<![^ ])\\+-(?=[ 0-9])")), QStringLiteral("\u00b1")},
        {QRegularExpression(QStringLiteral("(?<=[0-9]) deg\\b")), QStringLiteral("\u00b0")},
        {QRegularExpression(QStringLiteral("(?<=[0-9]) degC\\b")), QStringLiteral(" \u00b0C")},
        {QRegularExpression(QStringLiteral("(?<=\\bA/)deg\\b")), QStringLiteral("\u00b0")},
        {QRegularExpression(QStringLiteral("/\\(deg s\\)")), QStringLiteral("/(\u00b0\u00b7s)")},
        {QRegularExpression(QStringLiteral("/\\(rad s\\)")), QStringLiteral("/(rad\u00b7s)")}};
    for (const auto& [ascii, sign] : signs) {
        words.replace(ascii, sign);
    }
    return words;
}

} // namespace

QString inWords(const QString& english) {
    QString words = english;
    if (const auto here = windowTerms(english)) {
        words = *here;
    } else if (const auto found = sentence(english)) {
        words = *found;
    } else if (const auto several = sentences(english)) {
        words = several->join(QStringLiteral(". "));
    }
    return withSigns(words);
}

QString inWords(const std::string& english) {
    return inWords(QString::fromStdString(english));
}

bool isInPhrasebook(const QString& english) {
    return sentence(english) || sentences(english);
}

} // namespace halbench::widgets
