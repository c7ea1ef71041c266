#include "control/base/units.h"
#include "control/signals/spectrum.h"
#include "widgets/spectrogram/spectrogram_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Rate_Hz = 1000.0;
constexpr double Begin_Hz = 20.0;
constexpr double Slope_Hz_per_s = 30.0;
constexpr double Length_s = 10.0;

/// A linear chirp: the phase 2 pi (f0 t + k t^2 / 2) has the frequency f0 + k t.
SpectrogramPicture chirpPicture() {
    std::vector<double> time_s;
    std::vector<double> values;
    for (int row = 0; row < static_cast<int>(Length_s * Rate_Hz); ++row) {
        const double t = row / Rate_Hz;
        time_s.push_back(t);
        values.push_back(std::sin(2.0 * Pi * (Begin_Hz * t + 0.5 * Slope_Hz_per_s * t * t)));
    }
    control::SpectrumConfig config;
    config.segment_s = 0.25;
    const auto spectrogram = control::spectrogram({time_s, values, "A"}, config);
    EXPECT_TRUE(spectrogram);
    SpectrogramPicture picture;
    picture.time_s = spectrogram->time_s;
    picture.frequency_Hz = spectrogram->frequency_Hz;
    picture.values = spectrogram->values;
    return picture;
}

/// Two columns of three lines, and after a gap another.
SpectrogramPicture small() {
    SpectrogramPicture picture;
    picture.time_s = {1.0, 2.0, 5.0};
    picture.frequency_Hz = {0.0, 10.0, 20.0};
    picture.values = {1.0, 2.0, 3.0, 4.0, 50.0, 6.0, 7.0, 8.0, 9.0};
    return picture;
}

SpectrogramRaster rasterOf(const SpectrogramPicture& picture) {
    return SpectrogramRaster(std::make_shared<SpectrogramPicture>(picture));
}

TEST(SpectrogramRasterTest, theRidgeOfAChirpFollowsItsFrequencyWithinALine) {
    const SpectrogramPicture picture = chirpPicture();
    SpectrogramRaster raster = rasterOf(picture);
    const QwtInterval times = raster.interval(Qt::XAxis);
    const QwtInterval frequencies = raster.interval(Qt::YAxis);
    raster.initRaster(QRectF(times.minValue(), frequencies.minValue(), times.width(), frequencies.width()),
                      QSize(600, 1000));
    for (std::size_t column = 0; column < picture.time_s.size(); ++column) {
        const double at_s = picture.time_s[column];
        double ridge_Hz = 0.0;
        double highest = 0.0;
        for (int pixel = 0; pixel < 1000; ++pixel) { // half a line each
            const double at_Hz = frequencies.minValue() + frequencies.width() * (pixel + 0.5) / 1000.0;
            if (const double value = raster.value(at_s, at_Hz); value > highest) {
                highest = value;
                ridge_Hz = at_Hz;
            }
        }
        EXPECT_NEAR(ridge_Hz, Begin_Hz + Slope_Hz_per_s * at_s, picture.lineStep_Hz()) << at_s;
    }
}

TEST(SpectrogramRasterTest, aCellIsShownToTheHalfOfTheWayToItsNeighbours) {
    const SpectrogramRaster raster = rasterOf(small());
    EXPECT_EQ(raster.value(1.0, 10.0), 2.0);
    EXPECT_EQ(raster.value(1.49, 14.9), 2.0);
    EXPECT_EQ(raster.value(1.51, 15.1), 6.0);
    EXPECT_EQ(raster.interval(Qt::XAxis), QwtInterval(0.5, 5.5));
    EXPECT_EQ(raster.interval(Qt::YAxis), QwtInterval(-5.0, 25.0));
}

TEST(SpectrogramRasterTest, aGapAndWhatIsBeyondTheEndsAreEmpty) {
    const SpectrogramRaster raster = rasterOf(small());
    EXPECT_TRUE(std::isnan(raster.value(3.5, 10.0)));
    EXPECT_EQ(raster.value(4.6, 10.0), 8.0);
    EXPECT_TRUE(std::isnan(raster.value(0.4, 10.0)));
    EXPECT_TRUE(std::isnan(raster.value(1.0, 26.0)));
}

TEST(SpectrogramRasterTest, aPixelShowsTheLargestOfItsCells) {
    SpectrogramRaster raster = rasterOf(small());
    raster.initRaster(QRectF(0.0, 0.0, 3.0, 30.0), QSize(1, 1)); // 3 s and 30 Hz in one pixel
    EXPECT_EQ(raster.value(1.5, 10.0), 50.0);
}

/// 100 lines of 1 Hz, each with its number as its value.
SpectrogramPicture ladder() {
    SpectrogramPicture picture;
    picture.time_s = {1.0, 2.0};
    for (int column = 0; column < 2; ++column) {
        for (int line = 0; line <= 100; ++line) {
            if (column == 0) {
                picture.frequency_Hz.push_back(line);
            }
            picture.values.push_back(line);
        }
    }
    return picture;
}

// A pixel of a logarithmic axis of 3 pixels a decade reaches from f to 10^(1/3) f: at its lower end less than
// a line, at its upper end many.
TEST(SpectrogramRasterTest, onALogarithmicAxisAPixelIsAsWideAsItsPlaceSays) {
    SpectrogramPicture picture = ladder();
    picture.isFrequencyLogarithmic = true;
    picture.lowest_Hz = 1.0;
    picture.highest_Hz = 100.0;
    SpectrogramRaster raster = rasterOf(picture);
    EXPECT_EQ(raster.interval(Qt::YAxis), QwtInterval(1.0, 100.0));
    raster.initRaster(QRectF(0.5, 1.0, 2.0, 99.0), QSize(2, 6)); // 2 decades
    const double half = std::pow(10.0, 1.0 / 6.0);
    for (int pixel = 0; pixel < 6; ++pixel) {
        const double middle_Hz = std::pow(10.0, (pixel + 0.5) / 3.0);
        // The largest line below the pixel's upper end, or the nearest where there is none in it.
        const double inside = std::ceil(middle_Hz * half - 1e-9) - 1.0;
        const double expected = inside >= middle_Hz / half ? inside : std::round(middle_Hz);
        EXPECT_EQ(raster.value(1.0, middle_Hz), expected) << pixel;
    }
}

TEST(SpectrogramPictureTest, aLogarithmicAxisBeginsAboveTheLineAtZero) {
    SpectrogramPicture picture = ladder();
    EXPECT_EQ(frequencyRange(picture), (ValueRange{-0.5, 100.5}));
    picture.isFrequencyLogarithmic = true;
    EXPECT_EQ(frequencyRange(picture), (ValueRange{0.5, 100.5}));
    EXPECT_EQ(shownLines(picture), (std::pair<std::size_t, std::size_t>(1, 100)));
}

TEST(SpectrogramPictureTest, whatIsHighestAndTheColoursAreThoseOfTheLinesShown) {
    SpectrogramPicture picture = ladder();
    picture.isLogarithmic = false;
    picture.lowest_Hz = 5.0;
    picture.highest_Hz = 20.0;
    EXPECT_EQ(shownLines(picture), (std::pair<std::size_t, std::size_t>(5, 20)));
    EXPECT_EQ(highestCell(picture), (SpectrogramCell{0, 20}));
    EXPECT_EQ(colourRange(picture), (ValueRange{0.0, 20.0}));
    picture.brightest = 12.5;
    EXPECT_EQ(colourRange(picture), (ValueRange{0.0, 12.5}));
    picture.darkest = 13.0; // above the end
    EXPECT_EQ(colourRange(picture), (ValueRange{0.0, 20.0}));
    picture.isLogarithmic = true;
    picture.brightest.reset();
    picture.darkest = -1.0; // has no logarithm
    EXPECT_EQ(colourRange(picture), (ValueRange{1.0, 100.0}));
}

TEST(SpectrogramPictureTest, endsWithoutALineBetweenThemAreNone) {
    SpectrogramPicture picture = ladder();
    picture.lowest_Hz = 30.2;
    picture.highest_Hz = 30.7;
    EXPECT_EQ(frequencyRange(picture), (ValueRange{-0.5, 100.5}));
    picture.highest_Hz = 10.0;
    EXPECT_EQ(frequencyRange(picture), (ValueRange{-0.5, 100.5}));
}

TEST(SpectrogramPictureTest, findsWhereAValueIs) {
    const SpectrogramPicture picture = small();
    EXPECT_EQ(highestCell(picture), (SpectrogramCell{1, 1}));
    EXPECT_EQ(picture.columnAt(1.9), 1U);
    EXPECT_FALSE(picture.columnAt(3.5));
    EXPECT_EQ(picture.lineAt(24.0), 2U);
    EXPECT_FALSE(picture.lineAt(26.0));
    EXPECT_FALSE(SpectrogramPicture().columnAt(1.0));
}

TEST(SpectrogramPictureTest, coloursReachOverWholeDecadesAtMostSix) {
    SpectrogramPicture picture = small();
    EXPECT_EQ(colourRange(picture), (ValueRange{1.0, 100.0})); // 1 to 50
    picture.values.assign(9, 1e-12);
    picture.values.back() = 0.5;
    EXPECT_NEAR(colourRange(picture).low, 1e-6, 1e-18);
    EXPECT_EQ(colourRange(picture).high, 1.0);
    picture.values.assign(9, 0.0); // silence has no logarithm
    EXPECT_LT(colourRange(picture).low, colourRange(picture).high);
    picture.isLogarithmic = false;
    EXPECT_EQ(colourRange(picture).low, 0.0);
    picture.values[4] = 47.0;
    EXPECT_EQ(colourRange(picture), (ValueRange{0.0, 50.0}));
}

} // namespace
} // namespace halbench::widgets
