#include "devices/formats/mat_writer.h"

#include "devices/recording/file_access.h"
#include "devices/recording/time_axis.h"

#include <QtCore/QFile>
#include <QtCore/QtEndian>

#include <fmt/format.h>
#include <matio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <set>

namespace halbench::devices {

namespace {

constexpr const char* Header =
    "MATLAB 5.0 MAT-file, written by Halbench"; // libmatio's own has the time in it
constexpr std::size_t HeaderSize = 128;
constexpr std::size_t TagSize = 8;
constexpr std::size_t MaxName = 63;
constexpr std::size_t NumberSpace = 6; // for "_99999"
constexpr std::array Keywords = {
    "break",     "case",       "catch",         "classdef", "continue", "do",       "else",   "elseif",
    "end",       "endfor",     "endif",         "endwhile", "for",      "function", "global", "if",
    "otherwise", "parfor",     "return",        "spmd",     "switch",   "try",      "until",  "while",
    "endswitch", "persistent", "unwind_protect"};

bool isLetter(char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

std::string validName(const std::string& signal) {
    std::string name = signal.substr(0, MaxName - NumberSpace - 2);
    for (char& character : name) {
        const bool isDigit = character >= '0' && character <= '9';
        character = isLetter(character) || isDigit ? character : '_';
    }
    const bool isKeyword = std::find(Keywords.begin(), Keywords.end(), name) != Keywords.end();
    return isKeyword || name.empty() || !isLetter(name[0]) ? "x_" + name : name;
}

struct CloseMat {
    void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

/// libmatio's prototypes know no const; it only reads what it is given.
Variable makeVariable(const char* name, matio_classes kind, matio_types type, std::size_t rows,
                      std::size_t columns, const void* data, int options) {
    std::array<std::size_t, 2> size{rows, columns};
    return Variable(Mat_VarCreate(name, kind, type, 2, size.data(), const_cast<void*>(data), options));
}

/// A row of UTF-16, which is what MATLAB's characters are. libmatio copies it.
Variable textVariable(const char* name, const std::string& text) {
    const QString wide = QString::fromStdString(text);
    return makeVariable(name, MAT_C_CHAR, MAT_T_UINT16, wide.isEmpty() ? 0 : 1,
                        static_cast<std::size_t>(wide.size()), wide.utf16(), 0);
}

std::size_t filledUp(std::size_t octets) {
    return (octets + 7) / 8 * 8;
}

/// Octets of a matrix behind its tag: flags, two dimensions, its name (up to four letters stand in the tag),
/// data.
std::size_t matrixSize(std::string_view name, std::size_t dataOctets) {
    const std::size_t nameOctets = name.size() <= 4 ? TagSize : TagSize + filledUp(name.size());
    return 2 * TagSize + 2 * TagSize + nameOctets + TagSize + filledUp(dataOctets);
}

std::size_t textOctets(const std::string& text) {
    return static_cast<std::size_t>(QString::fromStdString(text).size()) * sizeof(char16_t);
}

/// Writes the variables and remembers how many octets they must have.
class MatWriter {
public:
    explicit MatWriter(mat_t* file) : m_file(file) {}

    void write(const Variable& variable, std::size_t octets) {
        m_isWritten = m_isWritten && variable &&
                      Mat_VarWrite(m_file, variable.get(), MAT_COMPRESSION_NONE) == MATIO_E_NO_ERROR;
        m_sizes.push_back(octets);
    }
    void writeColumn(const std::string& name, const std::vector<double>& values) {
        write(makeVariable(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, values.size(), 1, values.data(),
                           MAT_F_DONT_COPY_DATA),
              matrixSize(name, values.size() * sizeof(double)));
    }
    void writeText(const char* name, const std::string& text) {
        write(textVariable(name, text), matrixSize(name, textOctets(text)));
    }

    bool isWritten() const { return m_isWritten; }
    const std::vector<std::size_t>& sizes() const { return m_sizes; }

private:
    mat_t* m_file;
    bool m_isWritten = true;
    std::vector<std::size_t> m_sizes;
};

/// A text of each variable: its unit, or what its signal is called.
void writeTexts(MatWriter& writer, const char* variable, const std::vector<std::string>& names,
                const std::vector<std::string>& texts) {
    std::vector<const char*> fields{"time_s"};
    for (const std::string& name : names) {
        fields.push_back(name.c_str());
    }
    std::array<std::size_t, 2> one{1, 1};
    const Variable units(
        Mat_VarCreateStruct(variable, 2, one.data(), fields.data(), static_cast<unsigned>(fields.size())));
    std::size_t longest = 0;
    std::size_t octets = 0;
    for (std::size_t i = 0; units && i < fields.size(); ++i) {
        const std::string& text = texts[i];
        longest = std::max(longest, std::string_view(fields[i]).size() + 1);
        octets += TagSize + matrixSize({}, textOctets(text));
        Variable unit = textVariable(nullptr, text);
        Mat_VarSetStructFieldByName(units.get(), fields[i], 0, unit.release()); // the struct frees it
    }
    writer.write(units,
                 matrixSize(variable, fields.size() * longest) + TagSize + octets); // and how long names are
}

void writeVariables(MatWriter& writer, const Recording& recording, const RecordingMeta& meta) {
    const std::vector<std::string> names = matNames(*recording.layout);
    writer.writeColumn("time_s", recording.time_s);
    std::vector<double> values(recording.rows());
    for (std::size_t column = 0; column < names.size(); ++column) {
        for (std::size_t row = 0; row < values.size(); ++row) {
            values[row] = recording.values[row * names.size() + column];
        }
        writer.writeColumn(names[column], values);
    }
    std::vector<std::string> units{"s"};
    std::vector<std::string> signals{"time"};
    for (const StreamLayout::Column& column : recording.layout->columns) {
        units.push_back(column.unit);
        signals.push_back(column.name);
    }
    writeTexts(writer, "units", names, units);
    writeTexts(writer, "signals", names, signals);
    writer.writeText("meta_model", meta.device.model);
    writer.writeText("meta_id", meta.device.id);
    writer.writeText("meta_firmware", meta.device.firmware);
    writer.writeText("meta_started", meta.started);
    writer.writeText("meta_software", meta.software);
    writer.writeText("meta_json", toMetaJson(meta));
}

/// libmatio does not say when the disk is full: every variable must be there in its size, and the last one
/// must end with the file.
bool isWhole(QFile& file, const std::vector<std::size_t>& sizes) {
    auto place = static_cast<qint64>(HeaderSize);
    for (const std::size_t octets : sizes) {
        char tag[TagSize];
        if (!file.seek(place) || file.read(tag, TagSize) != static_cast<qint64>(TagSize)) {
            return false;
        }
        const auto size = qFromLittleEndian<quint32>(tag + 4);
        if (qFromLittleEndian<quint32>(tag) != MAT_T_MATRIX || size < octets) {
            return false;
        }
        place += static_cast<qint64>(TagSize) + size;
    }
    return place == file.size() && ::fsync(file.handle()) == 0;
}

Result<void> writeMat(const std::string& path, const Recording& recording, const RecordingMeta& meta) {
    std::unique_ptr<mat_t, CloseMat> mat(Mat_CreateVer(path.c_str(), Header, MAT_FT_MAT5));
    QFile file(QString::fromStdString(path));
    if (!mat || !file.open(QIODevice::ReadOnly)) {
        return cannotWrite(path, file);
    }
    MatWriter writer(mat.get());
    writeVariables(writer, recording, meta);
    if (Mat_Close(mat.release()) != 0 || !writer.isWritten() || !isWhole(file, writer.sizes())) {
        return failure(ErrorCode::FileSystem, fmt::format("cannot write '{}': incomplete", path),
                       "check that the folder can be written and the disk has room");
    }
    return {};
}

} // namespace

std::vector<std::string> matNames(const StreamLayout& layout) {
    std::set<std::string> taken{"time_s",        "units",        "signals",       "meta_model", "meta_id",
                                "meta_firmware", "meta_started", "meta_software", "meta_json"};
    std::vector<std::string> names;
    for (const StreamLayout::Column& column : layout.columns) {
        const std::string name = validName(column.name);
        std::string free = name;
        for (int number = 2; !taken.insert(free).second; ++number) {
            free = fmt::format("{}_{}", name, number);
        }
        names.push_back(free);
    }
    return names;
}

Result<void> writeMatFile(const std::string& path, const Recording& recording, RecordingMeta meta) {
    if (Result<void> folder = createFolderOf(path); !folder) {
        return folder;
    }
    meta.rows = recording.rows();
    meta.sha256.clear();
    nameColumnsOf(*recording.layout, meta);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        if (const std::uint64_t lost = lostRowsBefore(recording, row); lost != 0) {
            meta.gaps.push_back({recording.time_s[row], lost});
        }
    }
    const std::string partial = path + ".partial"; // takes the name when it is complete
    Result<void> written = writeMat(partial, recording, meta);
    written = written ? moveInto(partial, path) : written;
    if (!written) {
        std::remove(partial.c_str());
    }
    return written;
}

} // namespace halbench::devices
