#include "app/report/report.h"

#include "app/report/report_style.h"
#include "widgets/figure/figure_svg.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace halbench::app {
namespace {

constexpr int PlotWidth_px = 880;

/// Findings are ASCII as in files; what begins a word and leads a number is the sign, "a+-1" is a name.
std::string withPlusMinus(std::string text) {
    constexpr std::string_view Ascii = "+-";
    constexpr std::string_view Sign = "\u00b1";
    for (std::size_t at = text.find(Ascii); at != std::string::npos; at = text.find(Ascii, at + 1)) {
        const bool begins = at == 0 || text[at - 1] == ' ';
        const char next = at + Ascii.size() < text.size() ? text[at + Ascii.size()] : '\0';
        if (begins && (next == '\0' || next == ' ' || (next >= '0' && next <= '9'))) {
            text.replace(at, Ascii.size(), Sign);
        }
    }
    return text;
}

std::string escaped(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += c;
        }
    }
    return withPlusMinus(std::move(result));
}

/// Findings are written as clauses; a report sets several of them side by side.
std::string sentence(std::string text) {
    if (!text.empty()) {
        const char first = text.front();
        const bool isWord =
            text.size() > 1 && text[1] >= 'a' && text[1] <= 'z'; // leave symbols such as c/phi alone
        text.front() = isWord && first >= 'a' && first <= 'z' ? static_cast<char>(first - 'a' + 'A') : first;
        text += text.back() == '.' ? "" : ".";
    }
    return text;
}

std::string_view toneClass(ReportTone tone) {
    switch (tone) {
    case ReportTone::Good:
        return "good";
    case ReportTone::Warn:
        return "warn";
    case ReportTone::Bad:
        return "bad";
    case ReportTone::Muted:
        return "muted";
    case ReportTone::Plain:
        break;
    }
    return {};
}

/// ` class="..."`, or nothing when there is no class at all.
std::string classAttribute(std::string_view first, std::string_view second = {}) {
    if (first.empty() && second.empty()) {
        return {};
    }
    return fmt::format(" class=\"{}{}{}\"", first, first.empty() || second.empty() ? "" : " ", second);
}

/// Writes every kind of block; the first error of a plot is kept and ends the report.
class BlockWriter {
public:
    explicit BlockWriter(const widgets::Theme& theme) : m_theme(theme) {}

    void operator()(const ReportParagraph& paragraph) {
        m_html +=
            fmt::format("<p{}>{}</p>\n", classAttribute(toneClass(paragraph.tone)), escaped(paragraph.text));
    }

    void operator()(const ReportFacts& block) {
        m_html += "<dl>\n";
        for (const ReportFacts::Fact& fact : block.facts) {
            m_html += fmt::format("<div><dt>{}</dt><dd{}>{}</dd></div>\n", escaped(fact.label),
                                  classAttribute(toneClass(fact.tone)), escaped(fact.value));
        }
        m_html += "</dl>\n";
    }

    void operator()(const ReportTable& table) {
        m_html += "<div class=\"table\"><table>\n";
        if (!table.caption.empty()) {
            m_html += fmt::format("<caption>{}</caption>\n", escaped(table.caption));
        }
        m_html += "<thead><tr>";
        for (const ReportTable::Column& column : table.columns) {
            m_html += fmt::format("<th scope=\"col\"{}>{}</th>",
                                  classAttribute(column.isNumeric ? "number" : ""), escaped(column.title));
        }
        m_html += "</tr></thead>\n<tbody>\n";
        for (const auto& row : table.rows) {
            writeRow(table, row);
        }
        m_html += "</tbody></table></div>\n";
    }

    void operator()(const ReportQuality& block) {
        const Verdict verdict = block.quality.verdict;
        const std::string_view tone = verdict == Verdict::Good       ? "good"
                                      : verdict == Verdict::Doubtful ? "warn"
                                                                     : "bad";
        m_html += fmt::format(
            "<div class=\"quality {0}-edge\">\n<p><strong class=\"{0}\">Data quality: {1}</strong>", tone,
            verdictName(verdict));
        m_html += block.quality.findings.empty() ? " &#8211; no findings.</p>\n" : "</p>\n<ul>\n";
        for (const Finding& finding : block.quality.findings) {
            m_html += fmt::format("<li>{}", escaped(sentence(finding.message)));
            m_html += finding.hint.empty()
                          ? ""
                          : fmt::format(" <span class=\"muted\">{}</span>", escaped(sentence(finding.hint)));
            m_html += "</li>\n";
        }
        m_html += block.quality.findings.empty() ? "</div>\n" : "</ul>\n</div>\n";
    }

    void operator()(const ReportPlot& plot) {
        const Result<std::string> svg = widgets::figureSvg(plot.figure, m_theme, PlotWidth_px);
        if (!svg) {
            m_error = svg.error();
            return;
        }
        m_html += "<figure>\n" + *svg;
        if (!plot.caption.empty()) {
            m_html += fmt::format("<figcaption>{}</figcaption>\n", escaped(plot.caption));
        }
        m_html += "</figure>\n";
    }

    void write(std::string_view html) { m_html += html; }

    Result<std::string> finish() {
        if (m_error) {
            return failure(std::move(*m_error));
        }
        return std::move(m_html);
    }

private:
    void writeRow(const ReportTable& table, const std::vector<ReportTable::Cell>& row) {
        m_html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool isNumeric = i < table.columns.size() && table.columns[i].isNumeric;
            m_html += fmt::format("<td{}>{}</td>",
                                  classAttribute(isNumeric ? "number" : "", toneClass(row[i].tone)),
                                  escaped(row[i].text));
        }
        m_html += "</tr>\n";
    }

    const widgets::Theme& m_theme;
    std::string m_html;
    std::optional<Error> m_error;
};

std::string head(const ReportContent& content, const widgets::Theme& theme) {
    std::string html =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n<header>\n",
                    escaped(content.title), reportStyle(theme));
    html += fmt::format("<h1>{}</h1>\n<p class=\"badges\">", escaped(content.title));
    if (content.passed) {
        html += *content.passed ? "<span class=\"badge good\">&#10003; all checks passed</span>"
                                : "<span class=\"badge bad\">&#10007; a check missed its limit</span>";
    }
    if (content.isSimulated) {
        html += "<span class=\"badge simulated\">SIMULATED</span>";
    }
    html += "</p>\n";
    if (!content.summary.empty()) {
        html += fmt::format("<p>{}</p>\n", escaped(content.summary));
    }
    html += fmt::format("<p class=\"muted\">{} &#183; started {} &#183; Halbench {}</p>\n</header>\n",
                        escaped(content.device), escaped(content.started), HALBENCH_VERSION);
    return html;
}

std::string contents(const ReportContent& content) {
    if (content.sections.size() < 3) {
        return {};
    }
    std::string html = "<nav aria-label=\"Contents\">\n";
    for (std::size_t i = 0; i < content.sections.size(); ++i) {
        html += fmt::format("<a href=\"#section-{}\">{}</a>\n", i + 1, escaped(content.sections[i].heading));
    }
    return html + "</nav>\n";
}

} // namespace

Result<std::string> renderReport(const ReportContent& content) {
    const auto application = widgets::OffscreenApplication::ensure();
    if (!application) {
        return failure(application.error());
    }
    const Result<widgets::Theme> theme = widgets::loadTheme("light");
    if (!theme) {
        return failure(theme.error());
    }
    BlockWriter writer(*theme);
    writer.write(head(content, *theme));
    writer.write(contents(content));
    for (std::size_t i = 0; i < content.sections.size(); ++i) {
        const ReportSection& section = content.sections[i];
        writer.write(
            fmt::format("<section id=\"section-{}\">\n<h2>{}</h2>\n", i + 1, escaped(section.heading)));
        for (const ReportBlock& block : section.blocks) {
            std::visit(writer, block);
        }
        writer.write("</section>\n");
    }
    writer.write("</main>\n</body>\n</html>\n");
    return writer.finish();
}

void ReportFacts::addMeasured(std::string label, const std::optional<double>& value, int decimals,
                              const char* unit) {
    if (value) {
        facts.push_back({std::move(label), fmt::format("{:.{}f} {}", *value, decimals, unit)});
    }
}

} // namespace halbench::app
