#include "control/base/random.h"
#include "models/planar/planar_geometry.h"
#include "models/planar/prism_wrench.h"
#include "models/planar/published_wrench.h"
#include "models/planar/winding_shape.h"
#include "models/planar/windings_wrench.h"
#include "models/planar/wrench_map.h"
#include "wrench_checks.h"

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::models {
namespace {

const PlanarGeometry Nominal;
const PlanarPose CheckPose{2e-3, -3e-3, 0.0};
const double Pitch_m = Nominal.matrix.pitch_m;

PlanarPose randomPose(Random& random, double angle_rad) {
    return {0.1 * (random.uniform() - 0.5), 0.1 * (random.uniform() - 0.5),
            2.0 * angle_rad * (random.uniform() - 0.5)};
}

double largest(const CoilWrench& wrench) {
    return wrench.wrench.cwiseAbs().maxCoeff();
}

TEST(PlanarGeometry, coilsStandWhereTheTableSays) {
    // Theory section 2, millimetres with three decimals.
    const std::array<Eigen::Vector2d, CoilCount> expected_mm = {
        {{-38.1, -6.4}, {-38.1, -44.5}, {38.1, -44.5}, {38.1, -6.4}, {31.496, 44.4}, {-32.004, 44.4}}};
    const auto coils = Nominal.coils();
    for (std::size_t k = 0; k < coils.size(); ++k) {
        EXPECT_LT((1e3 * coils[k].centre_m - expected_mm[k]).norm(), 1e-9) << "coil " << k + 1;
    }
}

TEST(PublishedWrench, meetsTheCheckValues) {
    const PublishedWrench model(Nominal);
    EXPECT_NEAR(model.forceConstant_N_per_A(), -3.09772, 5e-6);
    EXPECT_NEAR(model.psi_rad(CheckPose.y_m), -2.73343298, 5e-9);
    EXPECT_NEAR(model.chi_rad(CheckPose.x_m), -6.85262990, 5e-9);
    const CoilWrench wrench = model.at(CheckPose);
    expectRow(wrench.wrench.row(0), {0, 0, 0, 0, -2.6089033, 1.6701813}, 1e-7);
    expectRow(wrench.wrench.row(1), {2.8432530, -1.2295505, -1.2295505, 2.8432530, 0, 0}, 1e-7);
    expectRow(wrench.wrench.row(2), {-0.1083279, 0.0468459, -0.0468459, 0.1083279, 0.1158353, -0.0741561},
              1e-7);
}

TEST(PublishedWrench, harmonicsHaveThePublishedRatios) {
    const double first = publishedForceConstant_N_per_A(Nominal, 1);
    EXPECT_NEAR(std::fabs(publishedForceConstant_N_per_A(Nominal, 5) / first), 0.009500, 5e-7);
    EXPECT_NEAR(std::fabs(publishedForceConstant_N_per_A(Nominal, 9) / first), 0.000096, 5e-7);
    EXPECT_NEAR(std::sqrt(2.0) * std::fabs(first), 4.381, 5e-4); // both coils of a pair at 1 A
}

TEST(PrismWrench, meetsTheCheckValues) {
    const CoilWrench wrench = PrismWrench(Nominal).at(CheckPose);
    expectRow(wrench.wrench.row(0), {0, 0, 0, 0, -2.6369449, 1.6619166}, 1e-7);
    expectRow(wrench.wrench.row(1), {2.8568371, -1.2034655, -1.2034655, 2.8568371, 0, 0}, 1e-7);
    expectRow(wrench.lift_N_per_A, {-1.2034655, -2.8568371, -2.8568371, -1.2034655, -1.6619166, -2.6369449},
              1e-7);
    expectRow(wrench.wrench.row(2), {-0.1088455, 0.0458520, -0.0458520, 0.1088455, 0.1170804, -0.0737891},
              1e-7);
}

TEST(PrismWrench, fundamentalAtZeroHeadingIsThePublishedModel) {
    const PrismWrench prism(Nominal, 1);
    const PublishedWrench published(Nominal);
    Random random(11);
    for (int i = 0; i < 50; ++i) {
        const PlanarPose pose = randomPose(random, 0.0);
        const CoilWrench a = prism.at(pose);
        const CoilWrench b = published.at(pose);
        // One formula in two arrangements: rounding of sums of a few newtons.
        EXPECT_LT((a.wrench - b.wrench).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_LT((a.lift_N_per_A - b.lift_N_per_A).cwiseAbs().maxCoeff(), 1e-12);
    }
}

// Second route to the prisms: J x B summed over midpoints, z exactly by the height integral's own rule.
CoilWrench summedPrisms(const PlanarPose& pose) {
    struct Side {
        double u, v, lu, lv, ju, jv;
    };
    const double a = Nominal.winding.width_m;
    const double p = Nominal.longStraight_m();
    const double q = Nominal.shortStraight_m();
    const double L = Pitch_m;
    const std::array<Side, 4> sides = {
        {{0, -L / 4, p, a, 1, 0}, {0, L / 4, p, a, -1, 0}, {L / 2, 0, a, q, 0, 1}, {-L / 2, 0, a, q, 0, -1}}};
    const int along = 160;
    const int across = 60;
    const int layers = 60;
    const auto coils = Nominal.coils();
    CoilWrench result;
    for (int k = 0; k < CoilCount; k += 4) { // one coil of each heading
        const PlanarCoil& coil = coils[static_cast<std::size_t>(k)];
        const Eigen::Matrix2d turn(Eigen::Rotation2Dd(pose.angle_rad + (coil.isAcross ? M_PI / 2.0 : 0.0)));
        const Eigen::Vector2d arm_m = Eigen::Rotation2Dd(pose.angle_rad) * coil.centre_m;
        for (const Side& side : sides) {
            const int nu = side.lu > side.lv ? along : across;
            const int nv = side.lu > side.lv ? across : along;
            const double cell = side.lu / nu * side.lv / nv * Nominal.winding.height_m / layers;
            const Eigen::Vector2d J = coil.sense * Nominal.winding.turnsPerWidth_1_m *
                                      Nominal.winding.layersPerHeight_1_m *
                                      (turn * Eigen::Vector2d(side.ju, side.jv));
            for (int i = 0; i < nu; ++i) {
                for (int j = 0; j < nv; ++j) {
                    const Eigen::Vector2d r_m =
                        arm_m + turn * Eigen::Vector2d(side.u + side.lu * ((i + 0.5) / nu - 0.5),
                                                       side.v + side.lv * ((j + 0.5) / nv - 0.5));
                    for (int l = 0; l < layers; l += 1) {
                        const double z = Nominal.gap_m + Nominal.winding.height_m * (l + 0.5) / layers;
                        const Eigen::Vector3d B = matrixField_T(
                            Nominal.matrix, Eigen::Vector3d(pose.x_m + r_m.x(), pose.y_m + r_m.y(), z));
                        const Eigen::Vector2d f = cell * B.z() * Eigen::Vector2d(J.y(), -J.x());
                        result.wrench(0, k) += f.x();
                        result.wrench(1, k) += f.y();
                        result.wrench(2, k) += r_m.x() * f.y() - r_m.y() * f.x();
                        result.lift_N_per_A(k) += cell * (J.x() * B.y() - J.y() * B.x());
                    }
                }
            }
        }
    }
    return result;
}

TEST(PrismWrench, closedFormIsTheSumOfForcesOverTheVolume) {
    const PlanarPose pose{13e-3, -21e-3, 0.3};
    const CoilWrench closed = PrismWrench(Nominal).at(pose);
    const CoilWrench summed = summedPrisms(pose);
    for (const int k : {0, 4}) {
        // Midpoint rule, 0.28 mm along and 0.1 mm across and high: (h g)^2/24 of each order, 5e-5 of the
        // first along a side, 7e-4 of the fifth in height, which is 1 % of the force: below 2e-4 of 3.3 N/A.
        EXPECT_LT((closed.wrench.col(k) - summed.wrench.col(k)).cwiseAbs().maxCoeff(), 6e-4);
        EXPECT_NEAR(closed.lift_N_per_A(k), summed.lift_N_per_A(k), 6e-4);
    }
    EXPECT_GT(largest(closed), 1.0);
}

TEST(WindingsWrench, meetsTheCheckValues) {
    const WindingsWrench model(Nominal);
    const CoilWrench level = model.at(CheckPose);
    expectRow(level.wrench.row(0), {0.0071861, 0.0071861, -0.0071861, -0.0071861, -2.9999643, 1.8896899},
              2e-6);
    expectRow(level.wrench.row(1), {3.2494021, -1.3677505, -1.3677505, 3.2494021, 0.0071766, 0.0071766},
              2e-6);
    expectRow(level.wrench.row(2), {-0.1237562, 0.0524311, -0.0524311, 0.1237562, 0.1334244, -0.0841319},
              2e-6);
    const CoilWrench turned = model.at({10e-3, 4e-3, 8e-3});
    expectRow(turned.wrench.row(0), {0.0019023, 0.0016459, -0.0016479, -0.0019044, -3.2873552, -1.2616452},
              2e-6);
    expectRow(turned.wrench.row(1), {1.1223519, -3.3313440, -3.3960760, 0.8694024, 0.0014900, 0.0019109},
              2e-6);
    expectRow(turned.wrench.row(2), {-0.0435275, 0.1253309, -0.1304219, 0.0330014, 0.1466388, 0.0547929},
              2e-6);
}

TEST(WindingsWrench, cornersAddThirteenPointSevenPercentOfForce) {
    const double first = windingsForceConstant_N_per_A(Nominal, 1);
    EXPECT_NEAR(first, -3.52301, 5e-6);
    EXPECT_NEAR(first / publishedForceConstant_N_per_A(Nominal), 1.1373, 5e-5);
    EXPECT_NEAR(std::fabs(windingsForceConstant_N_per_A(Nominal, 5) / first), 0.00978, 5e-6);
    EXPECT_NEAR(std::fabs(windingsForceConstant_N_per_A(Nominal, 9) / first), 0.00006, 5e-6);
    const double gamma = waveNumber_per_m(Nominal.matrix);
    EXPECT_NEAR(std::abs(windingShape_m2(Nominal, gamma, 0.0) / windingShape_m2(Nominal, 0.0, gamma)), 0.0022,
                5e-5);
}

TEST(WindingShape, flatFieldGivesTheAreaOfTheTurns) {
    // W(0, 0) = lambda integral of p q + 2 r (p + q) + pi r^2 over r = 0 ... a, closed form.
    const double a = Nominal.winding.width_m;
    const double p = Nominal.longStraight_m();
    const double q = Nominal.shortStraight_m();
    const double expected_m2 =
        Nominal.winding.turnsPerWidth_1_m * a * (p * q + a * (p + q) + M_PI * a * a / 3.0);
    EXPECT_NEAR(windingShape_m2(Nominal, 0.0, 0.0).real(), expected_m2, 1e-14 * expected_m2 + 1e-16);
}

TEST(WindingShape, isTheSumOverTheEnclosedAreaOfEachTurn) {
    // Second route: midpoint rule over the enclosed area with the turns' rounded outline, at the ninth order.
    const double g = 9.0 * waveNumber_per_m(Nominal.matrix);
    const double p = Nominal.longStraight_m();
    const double q = Nominal.shortStraight_m();
    const double A = g * std::cos(0.3);
    const double B = g * std::sin(0.3);
    double sum = 0.0;
    const int turns = 40;
    const int columns = 1500;
    for (int i = 0; i < turns; ++i) {
        const double r = Nominal.winding.width_m * (i + 0.5) / turns;
        const double half = 0.5 * p + r;
        for (int j = 0; j < columns; ++j) {
            const double u = half * ((j + 0.5) / columns);
            const double beyond = std::fmax(0.0, u - 0.5 * p);
            const double height = 0.5 * q + std::sqrt(r * r - beyond * beyond);
            sum += 4.0 * half / columns * std::cos(A * u) * std::sin(B * height) / B / turns;
        }
    }
    const double expected_m2 = Nominal.winding.turnsPerWidth_1_m * Nominal.winding.width_m * sum;
    // Midpoint in r: (h g)^2/24 = 1e-3 of a sum that oscillates over r; scale is the shape at zero heading.
    const double scale_m2 = std::abs(windingShape_m2(Nominal, 0.0, g));
    EXPECT_NEAR(windingShape_m2(Nominal, A, B).real(), expected_m2, 3e-3 * scale_m2);
    EXPECT_GT(std::fabs(expected_m2), 0.02 * scale_m2);
}

TEST(WindingsWrench, tableOfTheHeadingIsExactToTenDigits) {
    // The map at a heading inside the table against the integral itself, by the linkage of the flux.
    const WindingsWrench model(Nominal);
    const auto coils = Nominal.coils();
    for (const double angle_rad : {0.0, 3e-3, 0.0111, 0.02, 0.0333, 0.0499}) {
        const PlanarPose pose{3e-3, 8e-3, angle_rad};
        const auto linkage_Wb = model.linkage_Wb(pose);
        for (int k = 0; k < CoilCount; ++k) {
            const PlanarCoil& coil = coils[static_cast<std::size_t>(k)];
            const Eigen::Vector2d centre_m =
                Eigen::Vector2d(pose.x_m, pose.y_m) + Eigen::Rotation2Dd(angle_rad) * coil.centre_m;
            double expected_Wb = 0.0;
            for (const int order : MatrixOrders) {
                const double g = order * waveNumber_per_m(Nominal.matrix);
                const double along =
                    windingShape_m2(Nominal, g * std::cos(angle_rad), g * std::sin(angle_rad)).real();
                const double across =
                    windingShape_m2(Nominal, g * std::sin(angle_rad), g * std::cos(angle_rad)).real();
                expected_Wb += coil.sense * Nominal.winding.layersPerHeight_1_m *
                               coilHeightIntegral_Tm(Nominal, order) *
                               (std::cos(g * centre_m.x()) * (coil.isAcross ? across : along) +
                                std::cos(g * centre_m.y()) * (coil.isAcross ? along : across));
            }
            // The amplitude of the linkage is b1/gamma = 28 mWb.
            EXPECT_NEAR(linkage_Wb(k), expected_Wb, 1e-10 * 28e-3);
        }
    }
}

TEST(WindingsWrench, tableAndIntegralMeetAtTheEdge) {
    const WindingsWrench model(Nominal);
    const double edge_rad = WindingsWrench::TableLimit_rad;
    const CoilWrench inside = model.at({3e-3, 8e-3, edge_rad * (1.0 - 1e-12)});
    const CoilWrench outside = model.at({3e-3, 8e-3, edge_rad * (1.0 + 1e-12)});
    // Slopes of an interpolation are an order worse than values at the edge of its range.
    EXPECT_LT((inside.wrench - outside.wrench).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(WindingsWrench, isTheGradientOfItsFluxLinkage) {
    const WindingsWrench model(Nominal);
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        // Beyond 0.05 rad the table is left.
        const PlanarPose pose = randomPose(random, i < 15 ? 0.049 : 0.3);
        const CoilWrench wrench = model.at(pose);
        const auto slope = [&](double h, const auto& linkage) {
            return ((8.0 * (linkage(h) - linkage(-h)) - (linkage(2.0 * h) - linkage(-2.0 * h))) / (12.0 * h))
                .eval();
        };
        // h = 20 um (0.2 mrad on arms of 50 mm): h^4 (9 gamma)^4/30 = 8e-9 of the ninth order; rounding
        // 1e-16 x 28 mWb/h = 1e-13.
        const auto dx = slope(2e-5, [&](double h) {
            return model.linkage_Wb({pose.x_m + h, pose.y_m, pose.angle_rad});
        });
        const auto dy = slope(2e-5, [&](double h) {
            return model.linkage_Wb({pose.x_m, pose.y_m + h, pose.angle_rad});
        });
        const auto dz = slope(2e-5, [&](double h) { return model.linkage_Wb(pose, h); });
        EXPECT_LT((wrench.wrench.row(0).transpose() - dx).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((wrench.wrench.row(1).transpose() - dy).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT((wrench.lift_N_per_A.transpose() - dz).cwiseAbs().maxCoeff(), 1e-9);
        if (std::fabs(std::fabs(pose.angle_rad) - WindingsWrench::TableLimit_rad) > 1e-3) {
            const auto dphi = slope(2e-4, [&](double h) {
                return model.linkage_Wb({pose.x_m, pose.y_m, pose.angle_rad + h});
            });
            EXPECT_LT((wrench.wrench.row(2).transpose() - dphi).cwiseAbs().maxCoeff(), 1e-9);
        }
    }
}

TEST(WindingsWrench, forceAlongAnAxisDoesNotDependOnTheOther) {
    const WindingsWrench windings(Nominal);
    const PrismWrench prism(Nominal);
    const double angle_rad = 0.01;
    const CoilWrench here = windings.at({3e-3, 8e-3, angle_rad});
    const CoilWrench otherY = windings.at({3e-3, 21e-3, angle_rad});
    const CoilWrench otherX = windings.at({-19e-3, 8e-3, angle_rad});
    EXPECT_LT((here.wrench.row(0) - otherY.wrench.row(0)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((here.wrench.row(1) - otherX.wrench.row(1)).cwiseAbs().maxCoeff(), 1e-14);
    // Sides without corners are no closed current: there the property is lost away from heading zero.
    EXPECT_GT(
        (prism.at({3e-3, 8e-3, angle_rad}).wrench.row(0) - prism.at({3e-3, 21e-3, angle_rad}).wrench.row(0))
            .cwiseAbs()
            .maxCoeff(),
        1e-3);
}

TEST(WrenchMap, everyModelRepeatsAfterAPitchAndTurnsAfterHalfAPitch) {
    Random random(3);
    for (const WrenchModel model : {WrenchModel::Windings, WrenchModel::Prism, WrenchModel::Published}) {
        const WrenchMap map(model, Nominal);
        for (int i = 0; i < 10; ++i) {
            const PlanarPose pose = randomPose(random, model == WrenchModel::Prism ? 0.0 : 0.02);
            const CoilWrench here = map.at(pose);
            const CoilWrench pitch = map.at({pose.x_m + Pitch_m, pose.y_m - Pitch_m, pose.angle_rad});
            EXPECT_LT((pitch.wrench - here.wrench).cwiseAbs().maxCoeff(), 1e-12);
            const CoilWrench half = map.at({pose.x_m + 0.5 * Pitch_m, pose.y_m, pose.angle_rad});
            EXPECT_LT((half.wrench.row(0) + here.wrench.row(0)).cwiseAbs().maxCoeff(), 1e-12);
            EXPECT_LT((half.wrench.row(1) - here.wrench.row(1)).cwiseAbs().maxCoeff(), 1e-12);
        }
    }
}

TEST(WrenchMap, holdsTheModelThatWasAskedFor) {
    const PlanarPose pose{10e-3, 4e-3, 8e-3};
    EXPECT_EQ(WrenchMap(WrenchModel::Windings, Nominal, 1).at(pose).wrench,
              WindingsWrench(Nominal, 1).at(pose).wrench);
    EXPECT_EQ(WrenchMap(WrenchModel::Prism, Nominal, 2).at(pose).wrench,
              PrismWrench(Nominal, 2).at(pose).wrench);
    EXPECT_EQ(WrenchMap(WrenchModel::Published, Nominal).at(pose).wrench,
              PublishedWrench(Nominal).at(pose).wrench);
}

} // namespace
} // namespace halbench::models
