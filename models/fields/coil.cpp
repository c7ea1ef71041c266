#include "models/fields/coil.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <array>
#include <cmath>
#include <complex>

namespace halbench::models {
namespace {

struct Node {
    double x; ///< in (-1, 1)
    double weight;
};

/// Gauss-Legendre nodes by Newton's method on the Legendre polynomial.
std::vector<Node> gaussNodes(int count) {
    std::vector<Node> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(Pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int iteration = 0; iteration < 100; ++iteration) {
            double previous = 1.0;
            double value = x;
            for (int k = 2; k <= count; ++k) {
                const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k;
                previous = value;
                value = next;
            }
            slope = count == 1 ? 1.0 : count * (x * value - previous) / (x * x - 1.0);
            const double change = value / slope;
            x -= change;
            if (std::abs(change) < 1e-15) {
                break;
            }
        }
        nodes.push_back({x, 2.0 / ((1.0 - x * x) * slope * slope)});
    }
    return nodes;
}

constexpr int NodesAlongSide = 20;
constexpr int NodesAlongEnd = 10;

/// The ring seen from the coil's frame: the coil's axis becomes +x.
std::vector<CuboidMagnet> magnetsSeenBy(const RadialCoil& coil, const HalbachRing& ring, double psi_rad) {
    return ringMagnets(ring, psi_rad - coil.axis_rad);
}

/// integral of r B_r dz along the side at tangential position y
double sideIntegral(const std::vector<CuboidMagnet>& magnets, const CoilFilament& filament, double y_m) {
    double sum = 0.0;
    for (const Node& node : gaussNodes(NodesAlongSide)) {
        const Eigen::Vector3d point_m(filament.radius_m, y_m, filament.halfLength_m * node.x);
        const Eigen::Vector3d field_T = magnetsField_T(magnets, point_m);
        sum += node.weight * filament.halfLength_m * (point_m.x() * field_T.x() + point_m.y() * field_T.y());
    }
    return sum;
}

/// integral of t B_z dt along the end turn at height z
double endIntegral(const std::vector<CuboidMagnet>& magnets, const CoilFilament& filament, double z_m) {
    double sum = 0.0;
    for (const Node& node : gaussNodes(NodesAlongEnd)) {
        const double t_m = filament.halfWidth_m * node.x;
        const Eigen::Vector3d field_T = magnetsField_T(magnets, Eigen::Vector3d(filament.radius_m, t_m, z_m));
        sum += node.weight * filament.halfWidth_m * t_m * field_T.z();
    }
    return sum;
}

double fluxThrough(const std::vector<CuboidMagnet>& magnets, const CoilFilament& filament) {
    double sum = 0.0;
    for (const Node& along : gaussNodes(NodesAlongSide)) {
        for (const Node& across : gaussNodes(NodesAlongEnd)) {
            const Eigen::Vector3d point_m(filament.radius_m, filament.halfWidth_m * across.x,
                                          filament.halfLength_m * along.x);
            sum += along.weight * across.weight * magnetsField_T(magnets, point_m).x();
        }
    }
    return sum * filament.halfWidth_m * filament.halfLength_m;
}

/// Field of a straight filament from start to end carrying 1 A (Biot-Savart), T/A.
Eigen::Vector3d straightField(const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                              const Eigen::Vector3d& point) {
    const Eigen::Vector3d a = point - start;
    const Eigen::Vector3d b = point - end;
    // B = mu0/(4 pi) (a x b)(|a| + |b|) / (|a||b| (|a||b| + a.b))
    const double product = a.norm() * b.norm();
    const Eigen::Vector3d cross(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                                a.x() * b.y() - a.y() * b.x());
    return 1e-7 * cross * (a.norm() + b.norm()) / (product * (product + a.dot(b)));
}

} // namespace

std::vector<CoilFilament> coilFilaments(const RadialCoil& coil, int sections) {
    HB_ASSERT(sections > 0);
    std::vector<CoilFilament> filaments;
    const std::vector<Node> nodes = gaussNodes(sections);
    for (const Node& radial : nodes) {
        for (const Node& tangential : nodes) {
            const double outward_m = 0.5 * coil.windowTangential_m * tangential.x;
            CoilFilament filament;
            filament.radius_m = coil.meanRadius_m + 0.5 * coil.windowRadial_m * radial.x;
            filament.halfWidth_m = 0.5 * coil.meanWidth_m + outward_m;
            filament.halfLength_m = 0.5 * coil.activeLength_m;
            filament.turns = coil.turns * radial.weight * tangential.weight / 4.0;
            filaments.push_back(filament);
        }
    }
    return filaments;
}

double rotorTorque_Nm_per_A(const RadialCoil& coil, const HalbachRing& ring, double psi_rad, int sections) {
    const std::vector<CuboidMagnet> magnets = magnetsSeenBy(coil, ring, psi_rad);
    double torque = 0.0;
    for (const CoilFilament& filament : coilFilaments(coil, sections)) {
        // Current up at +t, inwards at the top (-t direction), down at -t: normal of the loop is the coil's
        // axis.
        const double sides = sideIntegral(magnets, filament, filament.halfWidth_m) -
                             sideIntegral(magnets, filament, -filament.halfWidth_m);
        const double ends = endIntegral(magnets, filament, filament.halfLength_m) -
                            endIntegral(magnets, filament, -filament.halfLength_m);
        torque -= filament.turns * (sides + ends); // that is on the coil; the rotor feels the opposite
    }
    return torque;
}

double coilFluxLinkage_Wb(const RadialCoil& coil, const HalbachRing& ring, double psi_rad, int sections) {
    const std::vector<CuboidMagnet> magnets = magnetsSeenBy(coil, ring, psi_rad);
    double linkage_Wb = 0.0;
    for (const CoilFilament& filament : coilFilaments(coil, sections)) {
        linkage_Wb += filament.turns * fluxThrough(magnets, filament);
    }
    return linkage_Wb;
}

Eigen::Vector3d coilField_T_per_A(const RadialCoil& coil, const Eigen::Vector3d& point_m, int sections) {
    const double cosine = std::cos(coil.axis_rad);
    const double sine = std::sin(coil.axis_rad);
    const Eigen::Vector3d own_m(cosine * point_m.x() + sine * point_m.y(),
                                -sine * point_m.x() + cosine * point_m.y(), point_m.z());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const CoilFilament& filament : coilFilaments(coil, sections)) {
        const double r = filament.radius_m;
        const double w = filament.halfWidth_m;
        const double h = filament.halfLength_m;
        const std::array<Eigen::Vector3d, 4> corners = {Eigen::Vector3d(r, w, -h), Eigen::Vector3d(r, w, h),
                                                        Eigen::Vector3d(r, -w, h),
                                                        Eigen::Vector3d(r, -w, -h)};
        for (std::size_t i = 0; i < 4; ++i) {
            sum += filament.turns * straightField(corners[i], corners[(i + 1) % 4], own_m);
        }
    }
    return {cosine * sum.x() - sine * sum.y(), sine * sum.x() + cosine * sum.y(), sum.z()};
}

TorqueConstant phaseTorqueConstant(const RadialCoil& coil, const HalbachRing& ring, int sections) {
    // Twenty bars make orders 19 and 21 near the outer filaments; 48 samples keep them off orders 3 and 5.
    constexpr std::size_t Samples = 48;
    std::array<double, Samples> torque{};
    for (std::size_t i = 0; i < Samples; ++i) {
        torque[i] = rotorTorque_Nm_per_A(coil, ring, 2.0 * Pi * static_cast<double>(i) / Samples, sections);
    }
    std::array<std::complex<double>, 3> amplitude{};
    for (std::size_t i = 0; i < Samples; ++i) {
        // The opposite coil meets the same field half a turn later and is wound the other way round.
        const double both = torque[i] - torque[(i + Samples / 2) % Samples];
        for (std::size_t k = 0; k < amplitude.size(); ++k) {
            const double angle_rad = 2.0 * Pi * static_cast<double>((2 * k + 1) * i % Samples) / Samples;
            amplitude[k] += std::polar(2.0 / Samples, angle_rad) * both;
        }
    }
    const double fundamental = std::abs(amplitude[0]);
    return {fundamental, std::abs(amplitude[1]) / fundamental, std::abs(amplitude[2]) / fundamental};
}

double uniformFieldTorqueConstant_Nm_per_A(const RadialCoil& coil, double field_T) {
    return 2.0 * coil.turns * field_T * coil.activeLength_m * coil.meanWidth_m;
}

} // namespace halbench::models
