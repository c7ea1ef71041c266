#include "widgets/figure/figure_svg.h"
#include "widgets/figure/figures.h"
#include "widgets/figure/offscreen_application.h"

#include <QCoreApplication>
#include <QPointF>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace halbench::widgets {
namespace {

Figure stepFigure(int samples) {
    Curve measured{"measured <true>", {}, {}, CurveStyle::Line, {}};
    Curve points{"points", {0.5}, {50.0}, CurveStyle::HollowPoints, {}};
    for (int i = 0; i < samples; ++i) {
        measured.x.push_back(3.0 * i / samples);
        measured.y.push_back(100.0 * (1.0 - std::exp(-9.0 * measured.x.back())) + std::sin(1e3 * i));
    }
    Panel panel;
    panel.y = {"position", "deg", false, {}, {}, {}};
    panel.curves = {measured, points};
    panel.lines = {{ReferenceLine::Direction::Horizontal, 100.0, "reference"}};
    return {"Step of 100° & more", {"time", "s", false, {}, {}, {}}, {panel, panel}};
}

Result<std::string> draw(const Figure& figure) {
    const auto application = OffscreenApplication::ensure();
    return figureSvg(figure, loadTheme("light").value());
}

TEST(FigureSvg, isOneWellFormedElementWithTitlesAndLabels) {
    const auto svg = draw(stepFigure(200));
    ASSERT_TRUE(svg.has_value());
    QXmlStreamReader reader(QByteArray::fromStdString(*svg));
    QStringList texts;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement &&
            (reader.name() == QLatin1String("text") || reader.name() == QLatin1String("title"))) {
            texts << reader.readElementText();
        }
    }
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    for (const char* text :
         {"Step of 100° & more", "position [°]", "time [s]", "measured <true>", "reference", "100"}) {
        EXPECT_TRUE(texts.contains(QString::fromUtf8(text))) << text;
    }
    EXPECT_EQ(texts.count(QStringLiteral("measured <true>")),
              1); // the second panel's equal curve is not named again
}

TEST(FigureSvg, givesEqualBytesForEqualFigures) {
    EXPECT_EQ(draw(stepFigure(5000)).value(), draw(stepFigure(5000)).value());
}

TEST(FigureSvg, carriesNoDateIdOrForeignReference) {
    const std::string svg = draw(stepFigure(50)).value();
    EXPECT_EQ(svg.find("id=\""), std::string::npos);
    EXPECT_EQ(svg.find("href"), std::string::npos);
    EXPECT_EQ(svg.find("Qt"), std::string::npos);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
}

TEST(FigureSvg, drawsColumnsNotSamples) {
    const std::size_t small = draw(stepFigure(4000)).value().size();
    const std::size_t large = draw(stepFigure(400000)).value().size();
    // one column of two points a pixel: about as much for a hundred times the samples.
    EXPECT_LT(large, 2 * small);
}

TEST(FigureSvg, keepsCurvesInsideThePanelWhenTheExtentIsGiven) {
    Figure figure = stepFigure(200);
    figure.panels.resize(1);
    figure.panels[0].y.min = 40.0;
    figure.panels[0].y.max = 60.0;
    const std::string svg = draw(figure).value();
    const QRegularExpression lines(QStringLiteral("<polyline[^>]*points=\"([^\"]*)\""));
    int checked = 0;
    QRegularExpressionMatchIterator matches = lines.globalMatch(QString::fromStdString(svg));
    while (matches.hasNext()) {
        std::istringstream numbers(matches.next().captured(1).toStdString());
        std::vector<double> heights_px;
        double x = 0.0;
        double y = 0.0;
        char comma = 0;
        while (numbers >> x >> comma >> y) {
            heights_px.push_back(y);
        }
        if (heights_px.size() <= 2) {
            continue; // a tick or a legend's sample
        }
        // The panel starts below title and legend and is 220 px high; the pen may reach over by its width.
        EXPECT_GT(*std::min_element(heights_px.begin(), heights_px.end()), 24.0 + 18.0 - 3.0);
        EXPECT_LT(*std::max_element(heights_px.begin(), heights_px.end()), 24.0 + 18.0 + 220.0 + 3.0);
        ++checked;
    }
    EXPECT_GE(checked, 1);
}

TEST(FigureSvg, survivesAnEmptyAndANotFiniteCurve) {
    Figure figure = stepFigure(0);
    EXPECT_TRUE(draw(figure).has_value());
    figure.panels[0].curves[0] = {
        "gaps", {0.0, 1.0, 2.0}, {std::nan(""), INFINITY, std::nan("")}, CurveStyle::Line, {}};
    EXPECT_EQ(draw(figure).value().find("nan"), std::string::npos);
}

TEST(FigureSvg, refusesCurvesThatDoNotFit) {
    Figure figure = stepFigure(10);
    figure.panels[0].curves[0].y.pop_back();
    EXPECT_EQ(draw(figure).error().code, ErrorCode::InvalidInput);
    figure.panels.clear();
    EXPECT_EQ(draw(figure).error().code, ErrorCode::InvalidInput);
}

TEST(OffscreenApplication, refusesToDrawBesideAnApplicationWithoutGraphics) {
    int count = 1;
    char name[] = "test";
    char* arguments[] = {name, nullptr};
    const QCoreApplication plain(count, arguments);
    EXPECT_EQ(OffscreenApplication::ensure().error().code, ErrorCode::Internal);
}

/// Where the texts of a picture begin: left end and baseline, in pixels.
std::map<std::string, QPointF> placesOfTexts(const std::string& svg) {
    std::map<std::string, QPointF> places;
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    std::vector<QPointF> shifts = {{0.0, 0.0}};
    while (!reader.atEnd()) {
        const auto token = reader.readNext();
        if (token == QXmlStreamReader::StartElement) {
            const auto matrix = reader.attributes().value("transform").toString();
            const QStringList parts = matrix.mid(7).chopped(matrix.isEmpty() ? 0 : 1).split(',');
            const QPointF shift =
                parts.size() == 6 ? QPointF(parts[4].toDouble(), parts[5].toDouble()) : QPointF(0.0, 0.0);
            shifts.push_back(shifts.back() + shift);
            if (reader.name() == QLatin1String("text")) {
                const QPointF at(reader.attributes().value("x").toDouble(),
                                 reader.attributes().value("y").toDouble());
                const QPointF from = shifts.back();
                places[reader.readElementText().trimmed().toStdString()] = from + at;
                shifts.pop_back();
            }
        } else if (token == QXmlStreamReader::EndElement) {
            shifts.pop_back();
        }
    }
    return places;
}

// Crossings of a sampled loop crowd below its Nyquist frequency: more than the four places of a line.
TEST(FigureSvg, labelsOfLinesThatStandCloseTogetherDoNotOverlap) {
    Figure figure = stepFigure(2);
    figure.panels.resize(1);
    figure.panels[0].curves = {{{}, {0.0, 3.0}, {0.0, 1.0}, CurveStyle::Line, {}}};
    figure.panels[0].lines.clear();
    std::vector<std::string> labels;
    for (int i = 0; i < 9; ++i) {
        labels.push_back("margin " + std::to_string(i));
        figure.panels[0].lines.push_back(
            {ReferenceLine::Direction::Vertical, 2.9 + 0.01 * i, labels.back(), i > 0});
    }
    const auto svg = draw(figure);
    ASSERT_TRUE(svg);
    const auto places = placesOfTexts(*svg);
    for (const std::string& one : labels) {
        ASSERT_TRUE(places.count(one)) << one;
        for (const std::string& other : labels) {
            if (one < other) {
                const QPointF apart = places.at(one) - places.at(other);
                // Ten characters of 12 px are some 60 px wide, a row is 14 px high.
                EXPECT_TRUE(std::abs(apart.y()) >= 13.0 || std::abs(apart.x()) >= 50.0) << one << other;
            }
        }
    }
}

} // namespace
} // namespace halbench::widgets
