#include "app/report/report.h"
#include "app/report/report_blocks.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>

namespace halbench::app {
namespace {

ReportPlot plotOf(std::vector<double> x, std::vector<double> y) {
    widgets::Panel panel;
    panel.y = {"speed", "rad/s", false, {}, {}, {}};
    panel.curves = {{"measured", std::move(x), std::move(y), widgets::CurveStyle::Line, {}}};
    return {{"Speed", {"time", "s", false, {}, {}, {}}, {panel}}, "a caption"};
}

ReportContent sample() {
    ReportContent content;
    content.title = "Identify <and> retune";
    content.summary = "A & B";
    content.device = "htm, sim:htm?seed=1&c=2e-3";
    content.started = "1970-01-01T00:00:00Z";
    content.isSimulated = true;
    content.passed = false;
    content.sections = {
        {"Device", {ReportFacts{{{"seed", "1"}, {"firmware", "0.1.0"}}}}},
        {"Identification",
         {ReportQuality{{Verdict::Doubtful, {{"code", "only five points", "Sweep more currents."}}}},
          estimateTable("Parameters", {{"damping", "N*m*s/rad", 1.23e-3, 1.19e-3, 1.27e-3, "identified"}}),
          plotOf({0.0, 0.5, 1.0}, {0.0, 12.5, 20.25})}},
        {"Checks",
         {checkTable({{"step.overshoot_percent", "%", 7.5, {}, 12.0, true}}), ReportParagraph{"Done."}}},
    };
    return content;
}

QStringList matchesOf(const std::string& html, const char* pattern) {
    QStringList found;
    const QRegularExpression expression{QLatin1String(pattern)};
    QRegularExpressionMatchIterator matches = expression.globalMatch(QString::fromStdString(html));
    while (matches.hasNext()) {
        found << matches.next().captured(0);
    }
    return found;
}

TEST(Report, saysEverythingInWords) {
    const std::string html = renderReport(sample()).value();
    for (const char* words :
         {"<title>Identify &lt;and&gt; retune</title>", "A &amp; B", "SIMULATED", "a check missed its limit",
          "Data quality: doubtful", "Only five points.", "Sweep more currents.", "N·m·s/rad", "✓ passed",
          "at most 12", "a caption", "sim:htm?seed=1&amp;c=2e-3", "started 1970-01-01T00:00:00Z"}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
}

TEST(Report, writesPlusMinusAsASign) {
    ReportContent content = sample();
    content.sections = {{"Friction",
                         {ReportQuality{{Verdict::Good, {{"friction_band", "held within +-8.2 deg", ""}}}},
                          ReportParagraph{"half width, +-"}, ReportParagraph{"the file a+-1.csv"}}}};
    const std::string html = renderReport(content).value();
    for (const char* words : {"Held within \u00b18.2 deg.", "half width, \u00b1", "a+-1.csv"}) {
        EXPECT_NE(html.find(words), std::string::npos) << words;
    }
}

TEST(Report, isSelfContained) {
    const std::string html = renderReport(sample()).value();
    for (const char* foreign : {"<script", "<link", "<img", "src=", "url(", "@import", "<iframe"}) {
        EXPECT_EQ(html.find(foreign), std::string::npos) << foreign;
    }
    // The only address is the name of the SVG vocabulary; the only references lead to the report's own
    // sections.
    for (const QString& address : matchesOf(html, "https?://[^\"]*")) {
        EXPECT_EQ(address, QStringLiteral("http://www.w3.org/2000/svg"));
    }
    for (const QString& reference : matchesOf(html, "href=\"[^\"]*\"")) {
        EXPECT_TRUE(reference.startsWith(QLatin1String("href=\"#section-"))) << reference.toStdString();
    }
}

TEST(Report, hasTheSameBytesInEveryLocaleAndWithOrWithoutDisplay) {
    unsetenv("DISPLAY");
    setenv("LC_ALL", "C", 1);
    const std::string plain = renderReport(sample()).value();
    setenv("DISPLAY", ":99", 1);
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    setenv("LANG", "de_DE.UTF-8", 1);
    setenv("QT_SCALE_FACTOR", "2", 1);
    unsetenv("XDG_RUNTIME_DIR");
    QLocale::setDefault(QLocale(QLocale::German));
    testing::internal::CaptureStderr();
    const std::string german = renderReport(sample()).value();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(plain, german);
    EXPECT_NE(german.find(">0.5<"), std::string::npos); // tick labels keep their point
    EXPECT_STREQ(std::localeconv()->decimal_point, ".");
    setenv("LC_ALL", "C", 1);
}

TEST(Report, refusesAPlotWhoseCurveDoesNotFit) {
    ReportContent content = sample();
    content.sections[0].blocks.push_back(plotOf({0.0, 1.0}, {0.0}));
    EXPECT_EQ(renderReport(content).error().code, ErrorCode::InvalidInput);
}

TEST(Report, leavesBadgesOutThatDoNotApply) {
    ReportContent content = sample();
    content.isSimulated = false;
    content.passed.reset();
    const std::string html = renderReport(content).value();
    EXPECT_EQ(html.find("SIMULATED"), std::string::npos);
    EXPECT_EQ(html.find("class=\"badge "), std::string::npos);
}

TEST(ReportNumber, showsTwoDigitsOfTheIntervalAndNoPaddedExponent) {
    EXPECT_EQ(reportNumber(1.2312e-3, 4e-5), "0.001231");
    EXPECT_EQ(reportNumber(2.0, 0.13), "2.00");
    EXPECT_EQ(reportNumber(1.5e-7), "1.5e-7");
    EXPECT_EQ(reportNumber(2.5e12), "2.5e12");
    EXPECT_EQ(reportNumber(std::nullopt), "–");
    EXPECT_EQ(reportNumber(26.0), "26");
}

TEST(ReportBlocks, missingValuesAreDashesAndFailTheirCheck) {
    const ReportTable estimates = estimateTable("", {{"inertia", "kg*m^2", {}, {}, {}, "not identifiable"}});
    EXPECT_EQ(estimates.rows[0][1].text, "–");
    EXPECT_EQ(estimates.rows[0][5].text, "not identifiable");
    const ReportTable checks = checkTable({{"sweep.r_squared", "", {}, 0.99, {}, false}});
    EXPECT_EQ(checks.rows[0][3].text, "at least 0.99");
    EXPECT_NE(checks.rows[0][4].text.find("no value"), std::string::npos);
    EXPECT_EQ(checks.rows[0][4].tone, ReportTone::Bad);
}

TEST(ReportBlocks, halfWidthBesideZeroIsAbsolute) {
    const ReportTable table = estimateTable("", {{"asymmetry", "", -6e-4, -9.6e-3, 8.4e-3, "identified"}});
    EXPECT_EQ(table.rows[0][4].text, "±0.009");
    EXPECT_EQ(table.rows[0][2].text, "");
}

TEST(ReportBlocks, roundingOfTheBoardIsNoChange) {
    EXPECT_FALSE(differs({"stiction.threshold", "rad", 0.0027925268, static_cast<double>(0.0027925268F)}));
    EXPECT_TRUE(differs({"gain.ki", "", 0.0, 1e-9}));
}

TEST(ReportBlocks, changesAreSaidInWords) {
    const ReportTable table =
        changeTable("", {{"gain.kp", "A/rad", 10.0, 40.0}, {"limit.current", "A", 4.0, 4.0}});
    EXPECT_EQ(table.rows[0][4].text, "changed");
    EXPECT_EQ(table.rows[1][4].text, "same");
}

} // namespace
} // namespace halbench::app
