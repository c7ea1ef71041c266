#include "app/workspaces/actuators/spherical/estimator_panel.h"

#include "app/workbench/played_recording.h"
#include "app/workspaces/actuators/spherical/board_sensors.h"
#include "app/workspaces/actuators/spherical/live_field_rows.h"
#include "app/workspaces/parts/compact_table.h"
#include "app/workspaces/parts/field_grid.h"
#include "control/base/units.h"
#include "models/spherical/coverage/placed_sensor.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace halbench::app {

namespace {

constexpr int GridColumns = 4;
constexpr int Tick_ms = 100;
constexpr double Digits = 3.0;
constexpr int TimeDecimals = 2;
/// Choices of poses after those that are made.
constexpr int LiveRows = static_cast<int>(ComparedPosesNames.size());
constexpr int RowsOfRecording = LiveRows + 1;
constexpr double LiveLength_s = 10.0;
enum Column { Name, Rms, Worst, Shaft, Failures, Time, Columns };

/// In the order of EstimatorKind.
QString estimatorWords(models::EstimatorKind kind) {
    switch (kind) {
    case models::EstimatorKind::Tensor:
        return EstimatorPanel::tr("Tensor");
    case models::EstimatorKind::Projector:
        return EstimatorPanel::tr("Projector");
    case models::EstimatorKind::Refined:
        return EstimatorPanel::tr("Projector + Gauss-Newton step");
    case models::EstimatorKind::LevenbergMarquardt:
        return EstimatorPanel::tr("Levenberg-Marquardt");
    case models::EstimatorKind::Closed:
        return EstimatorPanel::tr("Closed form, additive model");
    case models::EstimatorKind::ClosedFitted:
        return EstimatorPanel::tr("Closed form + least squares");
    case models::EstimatorKind::Swarm:
        return EstimatorPanel::tr("Particle swarm, additive model");
    }
    return {};
}

/// Three significant digits, zeros at the end too: a column of them is read at a glance.
QString significantText(double value) {
    const double magnitude = value > 0.0 ? std::floor(std::log10(value)) : 0.0;
    const int decimals = static_cast<int>(std::clamp(Digits - 1.0 - magnitude, 0.0, 12.0));
    return widgets::fixedText(value, decimals);
}

double steadyTime_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

EstimatorPanel::EstimatorPanel(Workbench& bench, StopWatch now_s, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_now_s(std::move(now_s)) {
    QVBoxLayout* column = makePanelColumn(this);
    m_words = makeNote(this);
    m_words->setAccessibleName(tr("Sensors of the comparison"));
    column->addWidget(m_words);
    buildFields(*column);
    m_message = new widgets::MessageBar(this);
    buildTable();
    column->addWidget(m_table, 1);
    (new widgets::FloatingRows(*m_table, Qt::BottomEdge, this))->addRow(*m_message);
    m_note = makeNote(this);
    column->addWidget(m_note);
    showNote(nullptr);
    connect(&m_bench, &Workbench::deviceChanged, this, &EstimatorPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &EstimatorPanel::onDevice);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        if (m_progress != nullptr && !m_progress->isCancelled) {
            m_running->setProgress(m_progress->progress);
        }
    });
    onDevice();
}

EstimatorPanel::~EstimatorPanel() {
    if (m_progress != nullptr) {
        m_progress->isCancelled = true;
    }
}

void EstimatorPanel::buildFields(QBoxLayout& column) {
    auto* grid = new FieldGrid(GridColumns, this);
    m_poses = grid->addBox(tr("Poses"), tr("Poses on which the estimators are compared"),
                           {tr("Random"), tr("Trajectory 1: tilt at Φ = 0°"),
                            tr("Trajectory 2: tilt at Φ = 90°"), tr("Trajectory 3: around at Θ = 45°"),
                            tr("Trajectory 4: spiral"), tr("Rows of the last 10 seconds")});
    m_device = grid->addBox(tr("Readings from"), tr("Model that makes the readings of the sensors"),
                            {tr("Physical field"), tr("Additive model")});
    m_count = grid->addNumber({tr("Number of poses"),
                               tr("Random poses in the workspace, or rows, chosen evenly"),
                               {},
                               0,
                               10.0,
                               1e6,
                               1000.0});
    m_count->setQuantity(2000.0);
    m_spin = grid->addNumber({tr("Spin γ"), tr("Rotation about the shaft along a trajectory"),
                              QStringLiteral("°"), 1, -180.0, 180.0, 10.0});
    m_noise = grid->addNumber({tr("Noise"), tr("Noise of each reading, rms; at first that of the board"),
                               QStringLiteral("µT"), 1, 0.0, 1e5, 10.0});
    m_failure = grid->addNumber({tr("Failure above"), tr("A pose with a larger error has failed"),
                                 QStringLiteral("°"), 3, 0.001, 180.0, 0.1});
    m_failure->setQuantity(0.1);
    m_passes = grid->addNumber({tr("Harmonic passes"),
                                tr("How often the board's harmonics are corrected; 0: never"),
                                {},
                                0,
                                0.0,
                                20.0,
                                1.0});
    m_passes->setQuantity(4.0);
    m_seed = grid->addNumber(
        {tr("Seed"), tr("Equal seeds give equal poses and noise"), {}, 0, 0.0, 4294967295.0, 1.0});
    m_seed->setQuantity(1.0);
    connect(m_noise, &widgets::QuantityEdit::edited, this, [this] { m_isNoiseOfBoard = false; });
    connect(m_poses, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        want();
        refresh();
    });
    column.addWidget(grid);
    m_compare =
        makeButton({tr("Co&mpare estimators"), tr("Estimate all poses with each of them (Alt+M)"), {}}, this);
    connect(m_compare, &QPushButton::clicked, this, &EstimatorPanel::start);
    m_running = new widgets::ProgressRow(this);
    m_running->setText(tr("Comparing the estimators"));
    m_running->hide();
    connect(m_running, &widgets::ProgressRow::cancelRequested, this, &EstimatorPanel::cancel);
    auto* row = new QHBoxLayout;
    row->addWidget(m_compare);
    row->addWidget(m_running, 1);
    row->addStretch();
    column.addLayout(row);
}

void EstimatorPanel::buildTable() {
    m_table = new QTableWidget(0, Columns, this);
    m_table->setAccessibleName(tr("Estimators compared"));
    m_table->setHorizontalHeaderLabels({tr("Estimator"), tr("rms error [°]"), tr("Largest error [°]"),
                                        tr("Shaft, rms [°]"), tr("Failures"), tr("Time per pose [µs]")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setItemDelegate(new widgets::WholeNumbers(m_table));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->hide();
    setCompact(*m_table);
}

bool EstimatorPanel::hasDevice() const {
    return m_bench.hasValues() && isMadeFor(estimatorActuatorPanel(), m_bench.session().catalogue());
}

/// The figures of another device are not shown beside its sensors.
void EstimatorPanel::onDevice() {
    const bool isThere = hasDevice();
    const SensingBoard board = boardSensors(m_bench);
    const QString words = isThere
                              ? sensorsInWords(board)
                              : tr("Compares orientation estimators on the same poses. Connect a device that "
                                   "measures the field of a rotor in space, or play a recording of one.");
    if (isThere && words != m_words->text()) {
        cancel();
        m_message->clear();
        m_table->setRowCount(0);
        m_isNoiseOfBoard = true;
    }
    if (isThere && m_isNoiseOfBoard) {
        m_noise->setQuantity(1e6 * board.deviation_T);
    }
    m_words->setText(words);
    askRecording();
    want();
    refresh();
}

/// Of the device that is connected now, once.
void EstimatorPanel::askRecording() {
    const std::string uri = hasDevice() ? m_bench.session().info().uri : std::string();
    if (uri == m_recordingUri) {
        return;
    }
    m_recordingUri = uri;
    takeRecording(nullptr);
    if (uri.empty()) {
        return;
    }
    askPlayedRecording(m_bench.session(), *this,
                       [this, uri](std::shared_ptr<const devices::RecordedFile> file) {
                           if (uri == m_recordingUri) {
                               takeRecording(std::move(file));
                           }
                       });
}

/// The rows of a recording are a choice while it is played, and its first one.
void EstimatorPanel::takeRecording(std::shared_ptr<const devices::RecordedFile> file) {
    const bool isThere = file != nullptr && hasFieldReadings(file->recording);
    m_recording = isThere ? std::move(file) : nullptr;
    if (!isThere && m_poses->count() > RowsOfRecording) {
        m_poses->removeItem(RowsOfRecording);
    }
    if (isThere && m_poses->count() == RowsOfRecording) {
        m_poses->addItem(tr("Rows of the recording"));
        m_poses->setCurrentIndex(RowsOfRecording);
    }
    refresh();
}

bool EstimatorPanel::isOfRecording() const {
    return m_recording != nullptr && m_poses->currentIndex() == RowsOfRecording;
}

bool EstimatorPanel::isOfLiveRows() const {
    return m_poses->currentIndex() == LiveRows;
}

/// Those that came last, or all of the recording; none where poses are made.
std::shared_ptr<const devices::RecordedFile> EstimatorPanel::rows() const {
    if (!isOfLiveRows()) {
        return isOfRecording() ? m_recording : nullptr;
    }
    return std::make_shared<const devices::RecordedFile>(liveFieldRows(m_bench, LiveLength_s));
}

/// Streamed only while somebody looks and asks for them.
void EstimatorPanel::want() {
    const bool isWanted = isVisible() && hasDevice() && isOfLiveRows();
    m_bench.liveSignals().want(this, isWanted ? liveFieldSignals(m_bench.session().catalogue())
                                              : std::vector<std::string>());
}

void EstimatorPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
}

void EstimatorPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

ComparedPoses EstimatorPanel::poses() const {
    return isOfRows() ? ComparedPoses::Workspace : static_cast<ComparedPoses>(m_poses->currentIndex());
}

EstimatorComparisonConfig EstimatorPanel::config() const {
    const SensingBoard board = boardSensors(m_bench);
    EstimatorComparisonConfig config;
    config.device = static_cast<models::SphericalDevice>(m_device->currentIndex());
    config.sensing = sensingOf(board);
    models::PlacementDevice placed;
    placed.radius_m = meanRadius_m(board);
    placed.strength_T = board.calibration.field.strength_T;
    config.additive = models::additiveModelOf(placed, board.placement);
    config.poses = poses();
    config.spin_rad = degreesToRadians(m_spin->value());
    config.count = static_cast<int>(std::lround(m_count->value()));
    config.passes = static_cast<int>(std::lround(m_passes->value()));
    config.noise_T = m_noise->value() / 1e6;
    config.failureLimit_rad = degreesToRadians(m_failure->value());
    config.seed = static_cast<std::uint64_t>(m_seed->value());
    if (isOfRows()) {
        config.sensing.deviation_T = models::SphericalReadings::Constant(config.noise_T);
        config.possibleLimit_ratio = rowsLimit_ratio(board, config.noise_T);
    }
    return config;
}

/// What the thread computes.
std::function<Result<EstimatorComparison>()> EstimatorPanel::comparison() const {
    return [config = config(), running = m_progress, now_s = m_now_s, file = rows(),
            origin = m_bench.session().info().uri,
            board = boardSensors(m_bench)]() mutable -> Result<EstimatorComparison> {
        if (file != nullptr && file->recording.rows() == 0) {
            return failure(ErrorCode::Refused, "No row with all nine readings has come yet.",
                           "Wait a second, then compare again.");
        }
        if (file != nullptr) {
            Result<RecordedRows> rows = recordedRows(*file, origin, board, config.count);
            if (!rows) {
                return failure(rows.error());
            }
            config.rows = std::make_shared<const RecordedRows>(*std::move(rows));
        }
        const AnalysisControl control{[running] { return running->isCancelled.load(); },
                                      [running](double share) { running->progress = share; }};
        return compareEstimators(config, control, now_s);
    };
}

void EstimatorPanel::start() {
    m_message->clear();
    m_progress = std::make_shared<Running>();
    m_task.run(comparison(), [this](const Result<EstimatorComparison>& comparison) { take(comparison); });
    m_running->setProgress(0.0);
    m_tick.start(Tick_ms);
    refresh();
    m_running->setFocus();
}

void EstimatorPanel::cancel() {
    if (m_progress != nullptr) {
        m_progress->isCancelled = true;
        m_running->setCancelling();
    }
}

void EstimatorPanel::take(const Result<EstimatorComparison>& comparison) {
    const bool wasFocused = m_running->isAncestorOf(focusWidget());
    const bool wasCancelled = m_progress != nullptr && m_progress->isCancelled;
    m_tick.stop();
    m_progress.reset();
    refresh();
    if (wasFocused) {
        m_compare->setFocus();
    }
    if (comparison && !wasCancelled) {
        showComparison(*comparison);
    } else if (wasCancelled) {
        m_message->showMessage({widgets::Severity::Information, tr("The comparison was cancelled."), {}, {}});
    } else {
        m_message->showMessage({widgets::Severity::Error,
                                widgets::inWords(comparison.error().message),
                                widgets::inWords(comparison.error().hint),
                                {}});
    }
}

void EstimatorPanel::showComparison(const EstimatorComparison& comparison) {
    m_table->setRowCount(static_cast<int>(comparison.estimators.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        showRow(row, comparison.estimators[static_cast<std::size_t>(row)]);
    }
    showNote(&comparison);
}

/// What the errors are measured against.
void EstimatorPanel::showNote(const EstimatorComparison* comparison) {
    const QString time = tr("The time is that of one thread of this computer.");
    const QString errors =
        comparison == nullptr || comparison->isAgainstTruth
            ? tr("Errors are measured to the nearest of the four orientations with the same field.")
            : tr("The rows have no true angles (truth.alpha, truth.beta, truth.gamma): errors are "
                 "differences from the projector with a Gauss-Newton step.");
    m_note->setText(errors + QLatin1Char(' ') + time);
}

void EstimatorPanel::showRow(int row, const ComparedEstimator& estimator) {
    const QString none = QStringLiteral("–");
    const auto degrees = [&](double angle_rad) {
        return estimator.estimated > 0 ? significantText(radiansToDegrees(angle_rad)) : none;
    };
    const models::EstimatorErrors errors = estimator.errors.value_or(models::EstimatorErrors{});
    const QString failures = estimator.errors
                                 ? tr("%1 of %2")
                                       .arg(widgets::countText(static_cast<quint64>(errors.failures)),
                                            widgets::countText(static_cast<quint64>(errors.poses)))
                                 : tr("not usable");
    const QString texts[] = {
        estimatorWords(estimator.kind),
        degrees(errors.rms_rad),
        degrees(errors.worst_rad),
        degrees(estimator.shaftRms_rad),
        failures,
        estimator.timePerPose_s ? widgets::fixedText(1e6 * *estimator.timePerPose_s, TimeDecimals) : none};
    for (int column = 0; column < Columns; ++column) {
        auto* cell = new QTableWidgetItem(texts[column]);
        cell->setTextAlignment(
            static_cast<int>((column == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
        cell->setToolTip(widgets::inWords(estimator.reason));
        m_table->setItem(row, column, cell);
    }
}

void EstimatorPanel::refresh() {
    m_running->setVisible(m_progress != nullptr);
    m_compare->setVisible(m_progress == nullptr);
    m_compare->setEnabled(hasDevice());
    const bool isMade = !isOfRows();
    m_device->setEnabled(isMade);
    m_count->setEnabled(poses() == ComparedPoses::Workspace);
    m_spin->setEnabled(poses() != ComparedPoses::Workspace);
    m_noise->setToolTip(isMade ? tr("Noise of each reading, rms; at first that of the board")
                               : tr("Noise that the recorded readings have; nothing is added"));
}

ActuatorPanel estimatorActuatorPanel() {
    return {"estimators", QT_TRANSLATE_NOOP("Panels", "Estimators"), "monitor.md#estimators",
            boardSensorRoles(),
            [](Workbench& bench) -> QWidget* { return new EstimatorPanel(bench, steadyTime_s); }};
}

} // namespace halbench::app
