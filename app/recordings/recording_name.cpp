#include "app/recordings/recording_name.h"

#include "app/recordings/name_reservation.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QRegularExpression>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace halbench::app {

namespace {

constexpr int LongestName_octets = 200; // 255, and room for ".meta.json.partial.new" and "-2"
constexpr int LeastDigits = 3;
constexpr std::array<const char*, 5> Placeholders = {"device", "name", "date", "time", "number"};
constexpr const char* Refused = "<>:\"/\\|?*";
/// What a recording's files are called, complete or not.
constexpr std::array<const char*, 5> Endings = {".csv", ".csv.partial", ".mf4", ".meta.json",
                                                ".meta.json.partial"};

bool isRefused(QChar sign) {
    return sign.category() == QChar::Other_Control || QLatin1String(Refused).contains(sign);
}

/// Literal text, or the name of a placeholder.
struct Piece {
    QString text;
    bool isPlaceholder = false;
};

tl::unexpected<Error> wrongAt(int place, const std::string& what, const std::string& hint) {
    return failure(ErrorCode::InvalidInput, fmt::format("name mask, character {}: {}", place + 1, what),
                   hint);
}

constexpr const char* Known = "allowed are {device}, {name}, {date}, {time} and {number}";

/// The placeholder that begins at `place`; the mask goes on behind it.
Result<QString> placeholderAt(const QString& mask, int place) {
    const int end = mask.indexOf(QLatin1Char('}'), place);
    if (end < 0) {
        return wrongAt(place, "'{' without '}'", Known);
    }
    const QString name = mask.mid(place + 1, end - place - 1);
    const bool isKnown = std::any_of(Placeholders.begin(), Placeholders.end(),
                                     [&](const char* one) { return name == QLatin1String(one); });
    if (!isKnown) {
        return wrongAt(place, fmt::format("there is no placeholder '{}'", name.toStdString()), Known);
    }
    return name;
}

Result<void> checkLiteral(const QString& mask, int place) {
    const QChar sign = mask.at(place);
    if (sign == QLatin1Char('}')) {
        return wrongAt(place, "'}' without '{'", Known);
    }
    if (sign == QLatin1Char('/') || sign == QLatin1Char('\\')) {
        return wrongAt(place, "a name cannot contain a folder", "enter the folder in its own field");
    }
    if (isRefused(sign)) {
        const QString shown = sign.isPrint() ? QString(sign) : QStringLiteral("?");
        return wrongAt(place, fmt::format("'{}' is not allowed in file names", shown.toStdString()),
                       "use letters, digits, '-', '_' and '.'");
    }
    return {};
}

Result<std::vector<Piece>> piecesOf(const QString& mask) {
    std::vector<Piece> pieces;
    int numbers = 0;
    for (int place = 0; place < mask.size();) {
        if (mask.at(place) == QLatin1Char('{')) {
            const Result<QString> name = placeholderAt(mask, place);
            if (!name) {
                return failure(name.error());
            }
            if (*name == QLatin1String("number") && ++numbers > 1) {
                return wrongAt(place, "a second {number}", "use {number} only once");
            }
            pieces.push_back({*name, true});
            place += name->size() + 2;
            continue;
        }
        if (const Result<void> legal = checkLiteral(mask, place); !legal) {
            return failure(legal.error());
        }
        if (pieces.empty() || pieces.back().isPlaceholder) {
            pieces.emplace_back();
        }
        pieces.back().text += mask.at(place++);
    }
    return pieces;
}

QString valueOf(const QString& placeholder, const NameParts& parts) {
    // "2026-11-21T21:15:42Z", whatever the locale's digits are
    const QString date = parts.date.toUTC().toString(Qt::ISODate);
    if (placeholder == QLatin1String("date")) {
        return date.left(10);
    }
    if (placeholder == QLatin1String("time")) {
        return date.mid(11, 8).replace(QLatin1Char(':'), QLatin1Char('-'));
    }
    if (placeholder == QLatin1String("device")) {
        QString device = parts.device.isEmpty() ? QStringLiteral("recording") : parts.device;
        device.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9._-]+")), QStringLiteral("-"));
        return device;
    }
    return parts.name.isEmpty() ? QStringLiteral("recording") : legalFileName(parts.name);
}

/// A name with its number left open.
struct Frame {
    QString before;
    QString behind;
    bool hasNumber = false;
    QString with(int number) const {
        return before + QStringLiteral("%1").arg(number, LeastDigits, 10, QLatin1Char('0')) + behind;
    }
};

Frame frameOf(const std::vector<Piece>& pieces, const NameParts& parts) {
    Frame frame;
    for (const Piece& piece : pieces) {
        if (piece.isPlaceholder && piece.text == QLatin1String("number")) {
            frame.hasNumber = true;
            continue;
        }
        (frame.hasNumber ? frame.behind : frame.before) +=
            piece.isPlaceholder ? valueOf(piece.text, parts) : piece.text;
    }
    return frame;
}

int highestNumber(const QString& folder, const Frame& frame) {
    const QRegularExpression pattern(
        QStringLiteral("^%1(\\d{1,8})%2\\.")
            .arg(QRegularExpression::escape(frame.before), QRegularExpression::escape(frame.behind)),
        QRegularExpression::CaseInsensitiveOption);
    int highest = 0;
    const QStringList files = QDir(folder).entryList(QDir::Files | QDir::Hidden);
    for (const QString& file : files) {
        highest = std::max(highest, pattern.match(file).captured(1).toInt());
    }
    return highest;
}

} // namespace

QString recordedDevice(const devices::DeviceInfo& info) {
    const std::string& known = !info.id.empty() ? info.id : !info.model.empty() ? info.model : info.transport;
    return QString::fromStdString(known);
}

Result<void> checkNameMask(const QString& mask) {
    if (mask.trimmed().isEmpty()) {
        return failure(ErrorCode::InvalidInput, "the name mask is empty",
                       fmt::format("example: {}", DefaultNameMask));
    }
    if (mask.at(0).isSpace() || mask.at(0) == QLatin1Char('.')) {
        return wrongAt(0, "a name cannot begin with a space or a dot", "begin with a letter");
    }
    if (mask.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        return wrongAt(mask.size() - 4, "the file extension is added automatically", "omit .csv");
    }
    const auto pieces = piecesOf(mask);
    return pieces ? Result<void>() : failure(pieces.error());
}

QString legalFileName(const QString& text) {
    QString name = text.simplified();
    for (QChar& sign : name) {
        sign = isRefused(sign) ? QLatin1Char('-') : sign;
    }
    if (name.startsWith(QLatin1Char('.'))) { // would be hidden
        name[0] = QLatin1Char('-');
    }
    static const QRegularExpression kept(QStringLiteral("^(con|prn|aux|nul|com[0-9]|lpt[0-9])(?=\\.|$)"),
                                         QRegularExpression::CaseInsensitiveOption);
    name.replace(kept, QStringLiteral("\\1_"));
    return name.isEmpty() ? QStringLiteral("recording") : name;
}

bool isNameTaken(const QString& folder, const QString& name) {
    return std::any_of(Endings.begin(), Endings.end(), [&](const char* ending) {
        return QFileInfo::exists(QDir(folder).filePath(name + QLatin1String(ending)));
    });
}

Result<QString> firstRecordingName(const QString& mask, const NameParts& parts, const QString& folder,
                                   const std::function<bool(const QString&)>& isFree) {
    if (const Result<void> checked = checkNameMask(mask); !checked) {
        return failure(checked.error());
    }
    const Frame frame = frameOf(*piecesOf(mask), parts);
    int number = frame.hasNumber ? highestNumber(folder, frame) + 1 : 1;
    const auto make = [&] {
        const QString plain = frame.before + frame.behind;
        const bool isPlain = !frame.hasNumber && number == 1;
        return legalFileName(frame.hasNumber ? frame.with(number)
                             : isPlain       ? plain
                                             : plain + QStringLiteral("-%1").arg(number));
    };
    QString name = make();
    for (; !isFree(name); ++number, name = make()) {
    }
    if (const int octets = name.toUtf8().size(); octets > LongestName_octets) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the name of the recording would have {} bytes", octets),
                       fmt::format("shorten the name or the mask to {} bytes", LongestName_octets));
    }
    return name;
}

Result<QString> recordingName(const QString& mask, const NameParts& parts, const QString& folder) {
    return firstRecordingName(mask, parts, folder,
                              [&](const QString& name) { return !isNameTaken(folder, name); });
}

} // namespace halbench::app
