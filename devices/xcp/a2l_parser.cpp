#include "devices/xcp/a2l_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace halbench::devices::xcp {

namespace {

constexpr std::uint64_t MaxU32 = 0xFFFFFFFFU;
constexpr std::uint64_t MaxArray = 65536;
constexpr std::size_t MaxObjects = 65536;

Error tooMany(const char* what) {
    return {ErrorCode::InvalidInput, fmt::format("the board's description has too many {}", what),
            fmt::format("at most {} are read", MaxObjects)};
}

} // namespace

Result<A2lDescription> parseA2l(std::string_view text) {
    return A2lParser(text).parse();
}

Result<A2lDescription> A2lParser::parse() {
    bool hasProject = false;
    while (!m_lexer.isAtEnd()) {
        const A2lToken token = m_lexer.take();
        if (token.kind == A2lTokenKind::Begin && token.text == "PROJECT") {
            hasProject = true;
            project(token);
        } else if (token.kind == A2lTokenKind::Begin) {
            m_lexer.skipBlock(token);
        } else if (token.kind == A2lTokenKind::End) {
            m_lexer.fail(token.place, fmt::format("/end {} without its /begin", token.text));
        }
    }
    if (m_lexer.error()) {
        return failure(*m_lexer.error());
    }
    if (!hasProject) {
        return failure(ErrorCode::InvalidInput, "the board's description has no PROJECT block",
                       "this is not a description of a board");
    }
    if (m_description.measurements.size() > MaxObjects || m_description.characteristics.size() > MaxObjects) {
        return failure(tooMany("signals or parameters"));
    }
    resolve();
    return std::move(m_description);
}

void A2lParser::project(const A2lToken& begin) {
    m_description.project = m_lexer.takeWord("the project's name");
    m_lexer.takeString("the project's text");
    contents(
        begin,
        [this](const A2lToken& block) { block.text == "MODULE" ? module(block) : m_lexer.skipBlock(block); },
        [](const std::string&) {});
}

void A2lParser::module(const A2lToken& begin) {
    m_description.module = m_lexer.takeWord("the module's name");
    m_lexer.takeString("the module's text");
    contents(
        begin, [this](const A2lToken& block) { moduleBlock(block); }, [](const std::string&) {});
}

void A2lParser::moduleBlock(const A2lToken& begin) {
    struct Entry {
        const char* name;
        void (A2lParser::*read)(const A2lToken&);
    };
    constexpr Entry Entries[] = {
        {"MOD_COMMON", &A2lParser::modCommon},
        {"MOD_PAR", &A2lParser::modPar},
        {"RECORD_LAYOUT", &A2lParser::recordLayout},
        {"COMPU_METHOD", &A2lParser::compuMethod},
        {"COMPU_VTAB", &A2lParser::compuVtab},
        {"MEASUREMENT", &A2lParser::measurement},
        {"GROUP", &A2lParser::group},
        {"CHARACTERISTIC", &A2lParser::characteristic},
        {"IF_DATA", &A2lParser::moduleInterface},
    };
    for (const Entry& entry : Entries) {
        if (begin.text == entry.name) {
            (this->*entry.read)(begin);
            return;
        }
    }
    m_lexer.skipBlock(begin);
}

void A2lParser::modCommon(const A2lToken& begin) {
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); },
        [this](const std::string& word) {
            if (word == "BYTE_ORDER") {
                // BIG_ENDIAN is an old word for LSB-last files and means MSB_FIRST in all tools seen.
                const std::string order = m_lexer.takeWord("the byte order");
                m_description.order = order == "MSB_FIRST" || order == "BIG_ENDIAN" ? ByteOrder::BigEndian
                                                                                    : ByteOrder::LittleEndian;
            }
        });
}

void A2lParser::modPar(const A2lToken& begin) {
    contents(
        begin,
        [this](const A2lToken& block) {
            block.text == "MEMORY_SEGMENT" ? memorySegment(block) : m_lexer.skipBlock(block);
        },
        [this](const std::string& word) {
            if (word == "EPK") {
                m_description.epk = m_lexer.takeString("the EPK");
            } else if (word == "ADDR_EPK") {
                m_description.epkAddress =
                    static_cast<std::uint32_t>(m_lexer.takeUnsigned("the EPK's address", MaxU32));
            }
        });
}

void A2lParser::memorySegment(const A2lToken& begin) {
    A2lSegment segment;
    segment.name = m_lexer.takeWord("the segment's name");
    m_lexer.takeString("the segment's text");
    m_lexer.takeWord("the segment's program type");
    m_lexer.takeWord("the segment's memory type");
    m_lexer.takeWord("the segment's attribute");
    segment.address.offset =
        static_cast<std::uint32_t>(m_lexer.takeUnsigned("the segment's address", MaxU32));
    segment.size = static_cast<std::uint32_t>(m_lexer.takeUnsigned("the segment's size", MaxU32));
    for (int i = 0; i < 5; ++i) {
        m_lexer.takeNumber("a segment offset");
    }
    contents(
        begin, [&](const A2lToken& block) { segmentInterface(block, segment); }, [](const std::string&) {});
    m_description.segments.push_back(std::move(segment));
}

void A2lParser::recordLayout(const A2lToken& begin) {
    const std::string name = m_lexer.takeWord("the layout's name");
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); },
        [&](const std::string& word) {
            if (word == "FNC_VALUES") {
                m_lexer.takeNumber("the layout's position");
                if (const std::optional<DataType> type =
                        findDataType(m_lexer.takeWord("the layout's type"))) {
                    m_layouts[name] = *type;
                }
            }
        });
}

void A2lParser::compuMethod(const A2lToken& begin) {
    const std::string name = m_lexer.takeWord("the conversion's name");
    m_lexer.takeString("the conversion's text");
    const std::string kind = m_lexer.takeWord("the conversion's kind");
    m_lexer.takeString("the conversion's format");
    RawConversion raw;
    raw.conversion.unit = m_lexer.takeString("the conversion's unit");
    raw.isUsable = kind == "IDENTICAL" || kind == "TAB_VERB";
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); },
        [&](const std::string& word) { conversionCoefficients(word, raw); });
    m_conversions[name] = std::move(raw);
}

void A2lParser::conversionCoefficients(const std::string& word, RawConversion& raw) {
    if (word == "COMPU_TAB_REF") {
        raw.wordTable = m_lexer.takeWord("the table's name");
    } else if (word == "COEFFS_LINEAR") {
        raw.conversion.factor = m_lexer.takeNumber("the factor");
        raw.conversion.offset = m_lexer.takeNumber("the offset");
        raw.isUsable = raw.conversion.factor != 0.0;
    } else if (word == "COEFFS") {
        // raw = (a x^2 + b x + c) / (d x^2 + e x + f); with a = d = e = 0: x = (raw f - c) / b
        double k[6] = {};
        for (double& coefficient : k) {
            coefficient = m_lexer.takeNumber("a coefficient");
        }
        raw.isUsable = k[0] == 0.0 && k[3] == 0.0 && k[4] == 0.0 && k[1] != 0.0 && k[5] != 0.0;
        if (raw.isUsable) {
            raw.conversion.factor = k[5] / k[1];
            raw.conversion.offset = -k[2] / k[1];
        }
    }
}

void A2lParser::compuVtab(const A2lToken& begin) {
    const std::string name = m_lexer.takeWord("the table's name");
    m_lexer.takeString("the table's text");
    m_lexer.takeWord("the table's kind");
    const std::uint64_t count = m_lexer.takeUnsigned("the table's size", MaxArray);
    std::map<std::int64_t, std::string>& words = m_wordTables[name];
    for (std::uint64_t i = 0; i < count && !m_lexer.isAtEnd(); ++i) {
        const double value = m_lexer.takeNumber("a table value");
        std::string text = m_lexer.takeString("a table text");
        if (std::abs(value) < 1e15) {
            words[static_cast<std::int64_t>(value)] = std::move(text);
        }
    }
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); }, [](const std::string&) {});
}

void A2lParser::arraySize(A2lObject& object) {
    // ARRAY_SIZE n | NUMBER n | MATRIX_DIM x [y [z]]: elements in a row
    std::size_t count = 1;
    while (m_lexer.peek().kind == A2lTokenKind::Word && a2lNumber(m_lexer.peek().text)) {
        const std::size_t place = m_lexer.peek().place;
        const std::uint64_t size = m_lexer.takeUnsigned("the number of elements", MaxArray);
        count *= static_cast<std::size_t>(std::max<std::uint64_t>(size, 1));
        if (count > MaxArray) {
            m_lexer.fail(place, fmt::format("an array has more than {} elements", MaxArray));
            return;
        }
    }
    object.count = count;
}

void A2lParser::measurement(const A2lToken& begin) {
    A2lMeasurement object;
    Pending pending;
    object.place = begin.place;
    object.name = m_lexer.takeWord("the signal's name");
    object.help = m_lexer.takeString("the signal's text");
    pending.layout = m_lexer.takeWord("the signal's type");
    pending.conversion = m_lexer.takeWord("the signal's conversion");
    m_lexer.takeNumber("the signal's resolution");
    m_lexer.takeNumber("the signal's accuracy");
    object.lower = m_lexer.takeNumber("the signal's lower limit");
    object.upper = m_lexer.takeNumber("the signal's upper limit");
    contents(
        begin, [&](const A2lToken& block) { measurementInterface(block, object); },
        [&](const std::string& word) {
            if (word == "ECU_ADDRESS") {
                object.address.offset =
                    static_cast<std::uint32_t>(m_lexer.takeUnsigned("the signal's address", MaxU32));
            } else if (word == "ECU_ADDRESS_EXTENSION") {
                object.address.extension =
                    static_cast<std::uint8_t>(m_lexer.takeUnsigned("the address extension", 255));
            } else if (word == "PHYS_UNIT") {
                pending.unit = m_lexer.takeString("the signal's unit");
            } else if (word == "BIT_MASK") {
                object.bitMask = m_lexer.takeUnsigned("the bit mask", MaxU32);
            } else if (word == "ARRAY_SIZE" || word == "MATRIX_DIM") {
                arraySize(object);
            }
        });
    m_description.measurements.push_back(std::move(object));
    m_pendingMeasurements.push_back(std::move(pending));
}

void A2lParser::characteristic(const A2lToken& begin) {
    A2lCharacteristic object;
    Pending pending;
    object.place = begin.place;
    object.name = m_lexer.takeWord("the parameter's name");
    object.help = m_lexer.takeString("the parameter's text");
    const std::string kind = m_lexer.takeWord("the parameter's kind");
    object.kind = kind == "ASCII"     ? A2lCharacteristicKind::Ascii
                  : kind == "VAL_BLK" ? A2lCharacteristicKind::ValueBlock
                                      : A2lCharacteristicKind::Value;
    object.address.offset =
        static_cast<std::uint32_t>(m_lexer.takeUnsigned("the parameter's address", MaxU32));
    pending.layout = m_lexer.takeWord("the parameter's layout");
    m_lexer.takeNumber("the parameter's largest difference");
    pending.conversion = m_lexer.takeWord("the parameter's conversion");
    object.lower = m_lexer.takeNumber("the parameter's lower limit");
    object.upper = m_lexer.takeNumber("the parameter's upper limit");
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); },
        [&](const std::string& word) {
            if (word == "ECU_ADDRESS_EXTENSION") {
                object.address.extension =
                    static_cast<std::uint8_t>(m_lexer.takeUnsigned("the address extension", 255));
            } else if (word == "PHYS_UNIT") {
                pending.unit = m_lexer.takeString("the parameter's unit");
            } else if (word == "READ_ONLY") {
                object.isReadOnly = true;
            } else if (word == "NUMBER" || word == "MATRIX_DIM") {
                arraySize(object);
            }
        });
    const bool isUsable = kind == "VALUE" || kind == "ASCII" || kind == "VAL_BLK";
    if (isUsable) {
        m_description.characteristics.push_back(std::move(object));
        m_pendingCharacteristics.push_back(std::move(pending));
    }
}

void A2lParser::group(const A2lToken& begin) {
    A2lGroup group;
    group.name = m_lexer.takeWord("the group's name");
    group.title = m_lexer.takeString("the group's text");
    contents(
        begin,
        [&](const A2lToken& block) {
            if (block.text == "REF_MEASUREMENT" || block.text == "REF_CHARACTERISTIC") {
                references(block, group.members);
            } else {
                m_lexer.skipBlock(block);
            }
        },
        [&](const std::string& word) { group.isRoot = group.isRoot || word == "ROOT"; });
    m_description.groups.push_back(std::move(group));
}

void A2lParser::references(const A2lToken& begin, std::vector<std::string>& names) {
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); },
        [&](const std::string& word) { names.push_back(word); });
}

} // namespace halbench::devices::xcp
