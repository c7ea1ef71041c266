#include "control/base/random.h"
#include "control/identify/swept_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr double T = 0.01;
constexpr double Turn_rad_s = 5.0;

/// psi'' + a psi' = k i under held current, exactly from sample to sample.
class Rotor {
public:
    double angle = 0.0;
    double speed = Turn_rad_s;
    void step(double current) {
        const double E = std::exp(-A * T);
        angle += speed * (1.0 - E) / A + K / A * (T - (1.0 - E) / A) * current;
        speed = E * speed + K / A * (1.0 - E) * current;
    }
    static constexpr double A = 2.236, K = 26.0;
    static std::complex<double> response(double w) {
        const double E = std::exp(-A * T);
        const std::complex<double> z = std::polar(1.0, w * T);
        return K / A * ((T - (1.0 - E) / A) + (1.0 - E) / A * (1.0 - E) / (z - E)) / (z - 1.0);
    }
};

struct Record {
    std::vector<double> reference, input, output;
    std::vector<std::size_t> starts;
    SweptRows rows(std::size_t perSweep) const {
        SweptRows all;
        all.period_s = T;
        all.rowsPerSweep = perSweep;
        all.restRows = 250;
        all.starts = starts;
        all.turn_rad_s = Turn_rad_s;
        all.lowest_rad_s = 2.0 * M_PI * 0.5;
        all.highest_rad_s = 2.0 * M_PI * 2.4;
        all.reference = reference;
        all.input = input;
        all.output = output;
        return all;
    }
};

/// A loop with proportional and derivative action turns steadily and is swept again and again, at times that
/// jitter by up to 50 ms; each sweep leaves the reference where it stands. `noise`: of the sensor, rms; the
/// disturbance repeats with the turn.
Record swept(int sweeps, double noise, double turnDisturbance, std::uint64_t seed) {
    Random random(seed);
    const auto jitter = [&random] { return static_cast<int>(random.below(6)); };
    Record record;
    Rotor rotor;
    double shift = 0.0, ramp = 0.0, before = 0.0;
    const auto run = [&](int count, bool isSwept) {
        double offset = 0.0;
        for (int n = 0; n < count; ++n) {
            const double t = T * n;
            offset = isSwept ? 0.06 * std::sin(2.0 * M_PI * (0.5 + 1.9 * t / 16.0) * t) : 0.0;
            const double r = ramp + shift + offset;
            const double y =
                rotor.angle + turnDisturbance * std::sin(rotor.angle + 0.3) + noise * random.gaussian();
            const double error = r - y;
            const double u = 10.0 * error + 0.5 * (error - before) / T;
            before = error;
            record.reference.push_back(r);
            record.input.push_back(u);
            record.output.push_back(y);
            rotor.step(u);
            ramp += Turn_rad_s * T;
        }
        shift += offset;
    };
    run(1000, false);
    for (int i = 0; i < sweeps; ++i) {
        record.starts.push_back(record.reference.size());
        run(800 + jitter(), true);
        run(420 + jitter(), false);
    }
    return record;
}

// Nothing disturbs: what is left is the loop's swing at the end of the rest, e^(-zeta w 4 s) below 1e-6 of
// the sweep's, and the law's group of two or three lines that one frequency stands for (a/w changes by 10 %
// in it).
TEST(SweptEstimate, findsThePlantInALoopWithoutDisturbances) {
    const Record record = swept(4, 0.0, 0.0, 1);
    const auto points = estimateSweptPlant(record.rows(1215));
    ASSERT_TRUE(points) << points.error().message;
    EXPECT_EQ(points->size(), 20U);
    for (const PlantPoint& point : *points) {
        const auto G = Rotor::response(point.frequency_rad_s);
        EXPECT_NEAR(std::abs(point.value - G) / std::abs(G), 0.0, 4e-3) << point.frequency_rad_s;
        EXPECT_GT(point.coherence, 0.999);
    }
}

// Noise and a disturbance that repeats with the turn, in a loop that feeds both back: 95 % of all circles
// hold the plant. 5 x 20 points: fewer than 90 happens once in a hundred times (binomial).
TEST(SweptEstimate, itsCirclesHoldThePlantWithNoiseInTheLoop) {
    int held = 0;
    int all = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Record record = swept(8, 1e-3, 3e-3, seed);
        const auto points = estimateSweptPlant(record.rows(1215));
        ASSERT_TRUE(points);
        for (const PlantPoint& point : *points) {
            held += std::abs(point.value - Rotor::response(point.frequency_rad_s)) <= point.radius ? 1 : 0;
            ++all;
            EXPECT_LT(point.radius, 0.05 * std::abs(point.value));
        }
    }
    EXPECT_EQ(all, 100);
    EXPECT_GE(held, 90);
}

// Twice as many sweeps: circles smaller by the root of two, and a little more because what is fitted to the
// rests is known better and Student's allowance for few averages shrinks.
TEST(SweptEstimate, moreSweepsMakeSmallerCircles) {
    const auto sizeOf = [](int sweeps) {
        double sum = 0.0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const Record record = swept(sweeps, 1e-3, 0.0, seed);
            const auto points = estimateSweptPlant(record.rows(1215));
            for (const PlantPoint& point : points.value()) {
                sum += point.radius / std::abs(point.value);
            }
        }
        return sum;
    };
    const double ratio = sizeOf(8) / sizeOf(16);
    EXPECT_GT(ratio, 1.3);
    EXPECT_LT(ratio, 1.9);
}

TEST(SweptEstimate, withoutExcitationNothingIsCoherentOrItIsRefused) {
    Record record = swept(4, 1e-3, 0.0, 1);
    for (std::size_t i = 0; i < record.reference.size(); ++i) {
        record.reference[i] = Turn_rad_s * T * static_cast<double>(i);
    }
    const auto points = estimateSweptPlant(record.rows(1215));
    EXPECT_TRUE(!points || points->front().coherence < 0.9);
}

TEST(SweptEstimate, refusesWhatAreNoSweeps) {
    const Record record = swept(4, 0.0, 0.0, 1);
    SweptRows rows = record.rows(1215);
    rows.starts.pop_back();
    EXPECT_EQ(estimateSweptPlant(rows).error().code, ErrorCode::InvalidInput);
    rows = record.rows(1215);
    rows.restRows = 0; // what disturbs could not be told from what is excited
    EXPECT_EQ(estimateSweptPlant(rows).error().code, ErrorCode::InvalidInput);
    rows = record.rows(1400); // they would overlap
    EXPECT_EQ(estimateSweptPlant(rows).error().code, ErrorCode::InvalidInput);
    rows = record.rows(1215);
    rows.highest_rad_s = 400.0; // beyond half the rate
    EXPECT_EQ(estimateSweptPlant(rows).error().code, ErrorCode::InvalidInput);
    std::vector<double> broken = record.output;
    broken[2000] = std::nan("");
    rows = record.rows(1215);
    rows.output = broken;
    EXPECT_EQ(estimateSweptPlant(rows).error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::control
