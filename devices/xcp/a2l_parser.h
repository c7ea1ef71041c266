#pragma once

#include "devices/xcp/a2l.h"
#include "devices/xcp/a2l_lexer.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// Recursive descent over the tokens of one description. Used by parseA2l() only.
class A2lParser {
public:
    explicit A2lParser(std::string_view text) : m_lexer(text) {}
    Result<A2lDescription> parse();

private:
    /// A conversion as written; references are resolved when everything is read, since they may come later.
    struct RawConversion {
        A2lConversion conversion;
        std::string wordTable;
        bool isUsable = true;
    };
    struct Pending {
        std::string conversion;
        std::string layout;
        std::string unit;
    };

    /// Calls `onBlock(begin)` for each inner block and `onWord(word)` for each word until this block's /end.
    template <typename OnBlock, typename OnWord>
    void contents(const A2lToken& begin, OnBlock onBlock, OnWord onWord);

    void project(const A2lToken& begin);
    void module(const A2lToken& begin);
    void moduleBlock(const A2lToken& begin);
    void modCommon(const A2lToken& begin);
    void modPar(const A2lToken& begin);
    void memorySegment(const A2lToken& begin);
    void recordLayout(const A2lToken& begin);
    void compuMethod(const A2lToken& begin);
    void conversionCoefficients(const std::string& word, RawConversion& raw);
    void compuVtab(const A2lToken& begin);
    void measurement(const A2lToken& begin);
    void characteristic(const A2lToken& begin);
    void group(const A2lToken& begin);
    void references(const A2lToken& begin, std::vector<std::string>& names);
    void arraySize(A2lObject& object);

    // IF_DATA XCP at its four places (a2l_interface.cpp)
    bool entersXcp(const A2lToken& begin);
    void moduleInterface(const A2lToken& begin);
    void protocolLayer(const A2lToken& begin);
    void daq(const A2lToken& begin);
    void daqEvent(const A2lToken& begin);
    void segmentInterface(const A2lToken& begin, A2lSegment& segment);
    void segmentPages(const A2lToken& begin, A2lSegment& segment);
    void page(const A2lToken& begin, A2lSegment& segment);
    void measurementInterface(const A2lToken& begin, A2lMeasurement& measurement);
    void eventList(const A2lToken& begin, std::vector<std::uint16_t>& events);

    void resolve();
    bool resolveObject(A2lObject& object, const Pending& pending);
    bool resolveConversion(A2lObject& object, const Pending& pending);
    void resolveLimits(A2lObject& object);
    void warn(const A2lObject& object, const std::string& what);

    A2lLexer m_lexer;
    A2lDescription m_description;
    std::map<std::string, RawConversion> m_conversions;
    std::map<std::string, std::map<std::int64_t, std::string>> m_wordTables;
    std::map<std::string, DataType> m_layouts;
    std::vector<Pending> m_pendingMeasurements;
    std::vector<Pending> m_pendingCharacteristics;
};

template <typename OnBlock, typename OnWord>
void A2lParser::contents(const A2lToken& begin, OnBlock onBlock, OnWord onWord) {
    while (!m_lexer.isAtEnd()) {
        const A2lToken token = m_lexer.take();
        if (token.kind == A2lTokenKind::Begin) {
            onBlock(token);
        } else if (token.kind == A2lTokenKind::Word) {
            onWord(token.text);
        } else if (token.kind == A2lTokenKind::End) {
            if (token.text != begin.text) {
                m_lexer.fail(token.place,
                             "found /end " + token.text + " where /end " + begin.text + " is expected");
            }
            return;
        }
    }
    m_lexer.fail(begin.place, "block " + begin.text + " does not end");
}

} // namespace halbench::devices::xcp
