#include "app/workbench/reference_run.h"

#include "app/procedures/excite/table_reference.h"
#include "app/workbench/drive_orders.h"

#include <algorithm>
#include <string>
#include <utility>

namespace halbench::app {

namespace {

constexpr double ShapeRamp = 2.0;

} // namespace

std::size_t ReferenceRun::runningShape() const {
    const double code =
        m_startedShape ? *m_startedShape : m_bench.deviceValue(m_axes.generator("shape")).value_or(0.0);
    return static_cast<std::size_t>(std::max(code, 0.0));
}

bool ReferenceRun::rampsOnBoard() const {
    return continuesReference(m_bench.session().info().firmware) &&
           m_bench.session().catalogue().findParameter(m_axes.generator("rate")) != nullptr;
}

bool ReferenceRun::admitsStart() {
    const std::string& firmware = m_bench.session().info().firmware;
    const bool leaps =
        m_axes.isPositionMode() && m_axes.motion().reference.hasRun() && !continuesReference(firmware);
    if (leaps) {
        Q_EMIT m_commands.failed(
            tr("Not started: with this firmware (%1) the motion would begin at the arming position and the "
               "rotor would jump.")
                .arg(QString::fromStdString(firmware)),
            tr("Disarm and arm, then start. Firmware 0.2.0 and later starts at the present position."));
    }
    return !leaps;
}

void ReferenceRun::startPath(const MoveReference& reference, const std::vector<std::string>& axes) {
    std::vector<ParameterValue> values = generatorParameters(reference, 0.0);
    values.push_back({"reference.start", 1.0});
    values = inMode(m_axes.mode(), m_axes.withAllHeld(std::move(values)));
    m_commands.change(
        [reference, values](devices::Device& device) {
            const auto written = isTable(reference) ? writeTable(device, reference, {}) : Result<void>();
            return written ? device.writeParameters(values) : written;
        },
        [this, code = static_cast<double>(reference.shape), axes] {
            m_startedShape = code;
            m_pathAxes = axes;
            m_axes.motion().reference.begin();
            for (const std::string& axis : axes) {
                m_axes.motionOf(axis).reference.begin();
            }
            m_bench.refreshValues();
        });
}

void ReferenceRun::start(std::vector<ParameterValue> values) {
    m_pathAxes.clear();
    m_axes.motion().reference.begin();
    m_startedShape.reset();
    for (const ParameterValue& value : values) {
        m_startedShape =
            value.name == m_axes.generator("shape") ? std::optional(value.value) : m_startedShape;
    }
    values.push_back({"reference.start", 1.0});
    m_commands.write(inMode(m_axes.mode(), m_axes.withOthersHeld(std::move(values))),
                     [this] { m_bench.refreshValues(); });
}

std::vector<ParameterValue> ReferenceRun::beginRamp(double rate, double amplitude, double duration_s) {
    m_pathAxes.clear();
    m_axes.motion().reference.begin();
    m_startedShape = ShapeRamp;
    return m_axes.withOthersHeld({{m_axes.generator("shape"), ShapeRamp},
                                  {m_axes.generator("rate"), rate},
                                  {m_axes.generator("amplitude"), amplitude},
                                  {m_axes.generator("base"), 0.0},
                                  {m_axes.generator("duration"), duration_s},
                                  {"reference.start", 1.0}});
}

void ReferenceRun::end() {
    m_commands.write({{"reference.start", 0.0}}, {});
}

void ReferenceRun::look(bool isDriven, bool isOnWay) {
    AxisMotion& motion = m_axes.motion();
    motion.reference.look(m_bench.history(), isDriven,
                          m_axes.isPositionMode() && !isOnWay ? motion.origin : std::nullopt, motion.setpoint,
                          m_axes.signal(m_axes.chosen().roles.reference));
    for (const devices::AxisSpec& axis : m_axes.all()) {
        const bool isOnPath = std::find(m_pathAxes.begin(), m_pathAxes.end(), axis.id) != m_pathAxes.end();
        if (isOnPath && axis.id != m_axes.chosen().id) {
            AxisMotion& other = m_axes.motionOf(axis.id);
            other.reference.look(m_bench.history(), isDriven,
                                 m_axes.isPositionMode() ? other.origin : std::nullopt, other.setpoint,
                                 m_axes.signal(axis.roles.reference));
        }
    }
}

} // namespace halbench::app
