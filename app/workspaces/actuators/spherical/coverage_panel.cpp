#include "app/workspaces/actuators/spherical/coverage_panel.h"

#include "app/analyses/spherical/proof_json.h"
#include "app/workspaces/actuators/spherical/board_sensors.h"
#include "app/workspaces/actuators/spherical/placement_editor.h"
#include "app/workspaces/parts/field_grid.h"
#include "control/base/units.h"
#include "models/spherical/spherical_parameters.h"
#include "widgets/actuators/spherical/coverage_view.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/painting.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPicture>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr int GridColumns = 4;
constexpr double Places_per_deg = 100.0; ///< of the slider
constexpr int SingleStep = 50;           ///< half a degree
constexpr int PageStep = 500;
constexpr int NoteLines = 2;
constexpr int LeastPictures_px = 260;
constexpr QSize PictureSize_px(900, 700);
constexpr std::array AngleNames = {"α", "β", "γ"};
constexpr std::array Components = {"R", "Θ", "Φ"};

QString angleName(std::size_t angle) {
    return QString::fromUtf8(AngleNames[angle]);
}

std::array<double, 3> anglesOf(const models::OrientationAngles& angles) {
    return {radiansToDegrees(angles.alpha_rad), radiansToDegrees(angles.beta_rad),
            radiansToDegrees(angles.gamma_rad)};
}

/// Rounded to a hundredth; no −0.
double hundredths(double angle_deg) {
    return std::round(angle_deg * 100.0) / 100.0 + 0.0;
}

widgets::SliceAxis axisOf(std::size_t angle, const models::AngleRange& range) {
    return {angleName(angle), radiansToDegrees(range.first_rad), radiansToDegrees(range.step_rad),
            range.count};
}

/// The angles down and across the map; gamma, where it is not held, across.
std::pair<std::size_t, std::size_t> freeAngles(HeldAngle held) {
    return {held == HeldAngle::Alpha ? 1U : 0U, held == HeldAngle::Gamma ? 1U : 2U};
}

} // namespace

CoveragePanel::CoveragePanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makeScrollingColumn(this);
    m_words = makeNote(this);
    m_words->setAccessibleName(tr("Sensors of the map"));
    column->addWidget(m_words);
    buildFields(*column);
    buildHeld(*column);
    buildPictures(*column);
    buildEnd(*column);
    connect(&m_bench, &Workbench::deviceChanged, this, &CoveragePanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this, &CoveragePanel::onDevice);
    onHeldAngle();
    onDevice();
}

CoveragePanel::~CoveragePanel() {
    if (m_isStopped != nullptr) {
        *m_isStopped = true;
    }
}

void CoveragePanel::buildFields(QBoxLayout& column) {
    auto* grid = new FieldGrid(GridColumns, this);
    m_quantity = grid->addBox(tr("Colours"), tr("Quantity that the colours show"),
                              {tr("Least reading"), tr("Predicted angle error")});
    m_device = grid->addBox(tr("Readings from"), tr("Model that makes the readings of the sensors"),
                            {tr("Physical field"), tr("Additive model")});
    m_threshold = grid->addNumber({tr("Threshold"), tr("Least reading of R, Θ and Φ in a covered pose"),
                                   QStringLiteral("mT"), 2, 0.0, 1000.0, 1.0});
    m_threshold->setQuantity(10.0);
    m_noise = grid->addNumber({tr("Noise"), tr("Noise of each reading, rms, for the predicted error"),
                               QStringLiteral("µT"), 1, 0.1, 1e5, 10.0});
    m_noise->setQuantity(100.0);
    column.addWidget(grid);
    const auto changed = qOverload<int>(&QComboBox::currentIndexChanged);
    connect(m_quantity, changed, this, &CoveragePanel::askSlice);
    connect(m_device, changed, this, &CoveragePanel::onDevice);
    connect(m_threshold, &widgets::QuantityEdit::edited, this, &CoveragePanel::onDevice);
    connect(m_noise, &widgets::QuantityEdit::edited, this, [this] {
        askSlice();
        askWorkspace();
    });
}

void CoveragePanel::buildHeld(QBoxLayout& column) {
    auto* name = new QLabel(tr("Held angle"), this);
    widgets::setRole(*name, widgets::Role::Muted);
    m_heldAngle = new QComboBox(this);
    m_heldAngle->setObjectName(QStringLiteral("held_choice"));
    m_heldAngle->setAccessibleName(name->text());
    m_heldAngle->setToolTip(tr("Angle of the slider; the map is over the other two"));
    for (std::size_t angle = 0; angle < AngleNames.size(); ++angle) {
        m_heldAngle->addItem(angleName(angle));
    }
    m_heldAngle->setCurrentIndex(static_cast<int>(HeldAngle::Gamma));
    name->setBuddy(m_heldAngle);
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setSingleStep(SingleStep);
    m_slider->setPageStep(PageStep);
    m_held = makeNumberField(
        {tr("Held angle"), tr("Angle at which the map is cut"), QStringLiteral("°"), 2, -90.0, 90.0, 0.5},
        this);
    m_held->setObjectName(QStringLiteral("held_angle"));
    auto* row = new QHBoxLayout;
    row->addWidget(name);
    row->addWidget(m_heldAngle);
    row->addWidget(m_slider, 1);
    row->addWidget(m_held);
    column.addLayout(row);
    connect(m_heldAngle, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        onHeldAngle();
        askSlice();
    });
    connect(m_slider, &QSlider::valueChanged, this, [this](int place) { hold(place / Places_per_deg); });
    connect(m_held, &widgets::QuantityEdit::edited, this, &CoveragePanel::hold);
}

void CoveragePanel::buildPictures(QBoxLayout& column) {
    m_sensors = new PlacementEditor(this);
    m_view = new widgets::CoverageView(this);
    m_view->setToolTip(tr("Click or arrow keys read a pose; Home goes to the middle"));
    auto* pictures = new QSplitter(Qt::Horizontal, this);
    pictures->addWidget(m_sensors);
    pictures->addWidget(m_view);
    pictures->setChildrenCollapsible(false);
    pictures->setMinimumHeight(LeastPictures_px);
    pictures->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // takes the room that is left
    pictures->setStretchFactor(0, 2);
    pictures->setStretchFactor(1, 3);
    column.addWidget(pictures, 1);
    connect(m_sensors, &PlacementEditor::placementChanged, this, &CoveragePanel::onSensors);
    connect(m_view, &widgets::CoverageView::cursorMoved, this, [this] {
        m_cursor->setText(m_view->cursorText());
        showPose();
    });
}

void CoveragePanel::buildEnd(QBoxLayout& column) {
    m_cursor = makeNote(this);
    m_cursor->setAccessibleName(tr("Pose read from the map"));
    reserveLines(*m_cursor, 1);
    column.addWidget(m_cursor);
    m_figures = makeNote(this);
    m_figures->setAccessibleName(tr("Figures of the placement"));
    reserveLines(*m_figures, 1);
    column.addWidget(m_figures);
    m_verdict = makeNote(this);
    m_verdict->setAccessibleName(tr("Coverage of all poses"));
    reserveLines(*m_verdict, NoteLines);
    column.addWidget(m_verdict);
    m_go = makeButton({tr("Go to &counterexample"), tr("Show the slice of the uncovered pose (Alt+C)"), {}},
                      this);
    m_save = makeButton({tr("Save &picture…"), tr("Save as SVG, PDF or PNG (Alt+P)"), {}}, this);
    m_back =
        makeButton({tr("&Board's placement"), tr("Show the sensors of the board again (Alt+B)"), {}}, this);
    m_recommended = makeButton(
        {tr("&Recommended"), tr("Try the placement that is proven to cover all (Alt+R)"), {}}, this);
    connect(m_back, &QPushButton::clicked, m_sensors, &PlacementEditor::goBack);
    connect(m_recommended, &QPushButton::clicked, m_sensors, &PlacementEditor::tryRecommended);
    connect(m_go, &QPushButton::clicked, this, &CoveragePanel::goToCounterexample);
    connect(m_save, &QPushButton::clicked, this, &CoveragePanel::savePicture);
    auto* row = new QHBoxLayout;
    row->addWidget(m_go);
    row->addWidget(m_back);
    row->addWidget(m_recommended);
    row->addWidget(m_save);
    row->addStretch();
    column.addLayout(row);
}

bool CoveragePanel::hasDevice() const {
    return m_bench.hasValues() && isMadeFor(coverageActuatorPanel(), m_bench.session().catalogue());
}

HeldAngle CoveragePanel::held() const {
    return static_cast<HeldAngle>(m_heldAngle->currentIndex());
}

models::CoverageModel CoveragePanel::model() const {
    const auto device = static_cast<models::SphericalDevice>(m_device->currentIndex());
    if (m_sensors->isOnTrial()) {
        return models::coverageModelOf(m_sensors->device(device), m_sensors->placement());
    }
    const SensingBoard board = boardSensors(m_bench);
    if (device == models::SphericalDevice::Additive) {
        return models::CoverageModel(
            models::AdditiveModel{board.calibration.field.strength_T, board.placement});
    }
    models::SphericalSensing sensing = sensingOf(board);
    sensing.field.harmonics.clear(); // the rule is about the main field
    return models::CoverageModel(sensing.field, sensing.poses);
}

CoverageSliceConfig CoveragePanel::config() const {
    CoverageSliceConfig config;
    config.quantity = m_quantity->currentIndex() == 0 ? models::CoverageQuantity::LeastComponent_T
                                                      : models::CoverageQuantity::PredictedDeviation_rad;
    config.threshold_T = m_threshold->value() / 1e3;
    config.noise_T = m_noise->value() / 1e6;
    config.held = held();
    config.held_rad = degreesToRadians(m_held->value());
    return config;
}

void CoveragePanel::onDevice() {
    if (hasDevice()) {
        m_sensors->setBoard(boardSensors(m_bench));
    }
    m_sensors->setEnabled(hasDevice());
    m_recommended->setEnabled(hasDevice());
    onSensors();
}

void CoveragePanel::onSensors() {
    m_back->setEnabled(hasDevice() && m_sensors->isOnTrial());
    if (!hasDevice()) {
        m_words->setText(tr("Shows where field sensors about a rotor read enough. Connect a device with "
                            "such sensors, or play a recording of one."));
    } else {
        SensingBoard board = boardSensors(m_bench);
        board.placement = m_sensors->placement();
        const QString words = sensorsInWords(board);
        m_words->setText(m_sensors->isOnTrial() ? tr("On trial, not on the board. %1").arg(words) : words);
    }
    askSlice();
    askJudgement();
    askWorkspace();
}

void CoveragePanel::onHeldAngle() {
    const double limit_deg = held() == HeldAngle::Gamma ? 90.0 : 45.0;
    const QString name = angleName(static_cast<std::size_t>(held()));
    const QSignalBlocker quiet(m_slider);
    m_slider->setAccessibleName(tr("Slider for %1").arg(name));
    m_slider->setToolTip(tr("Arrow keys: half a degree; Page Up and Down: five"));
    m_slider->setRange(static_cast<int>(-limit_deg * Places_per_deg),
                       static_cast<int>(limit_deg * Places_per_deg));
    m_held->setFormat({QStringLiteral("°"), -limit_deg, limit_deg, 0.5, 2});
    m_slider->setValue(static_cast<int>(std::lround(m_held->value() * Places_per_deg)));
}

void CoveragePanel::hold(double angle_deg) {
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(angle_deg * Places_per_deg)));
    m_held->setQuantity(angle_deg);
    askSlice();
}

void CoveragePanel::askSlice() {
    const bool isThere = hasDevice();
    m_save->setEnabled(isThere);
    if (!isThere) {
        m_slicing.cancel();
        m_view->setSlice({});
        return;
    }
    m_slicing.run(
        [model = model(), config = config()] { return coverageSlice(model, config); },
        [this, config = config()](const Result<SliceOfCoverage>& slice) { takeSlice(config, slice); });
}

void CoveragePanel::takeSlice(const CoverageSliceConfig& config, const Result<SliceOfCoverage>& slice) {
    if (!slice) {
        m_problem = widgets::inWords(slice.error().message);
        showWords();
        return;
    }
    m_problem.clear();
    const bool isReading = config.quantity == models::CoverageQuantity::LeastComponent_T;
    const auto [down, across] = freeAngles(config.held);
    const std::array ranges = {slice->grid.alpha, slice->grid.beta, slice->grid.gamma};
    widgets::CoverageSlice shown;
    shown.x = axisOf(across, ranges[across]);
    shown.y = axisOf(down, ranges[down]);
    shown.quantity = m_quantity->itemText(isReading ? 0 : 1);
    shown.unit = isReading ? QStringLiteral("mT") : QStringLiteral("°");
    shown.decimals = isReading ? 2 : 4;
    for (std::size_t i = 0; i < slice->value.size(); ++i) {
        const double value = static_cast<double>(slice->value[i]);
        shown.values.push_back(isReading ? 1e3 * value : radiansToDegrees(value));
        shown.isUncovered.push_back(!(static_cast<double>(slice->least_T[i]) > config.threshold_T));
    }
    const auto [low, high] = std::minmax_element(shown.values.begin(), shown.values.end());
    shown.low = isReading ? 0.0 : *low;
    shown.high = *high > shown.low ? *high : shown.low + 1.0;
    m_uncovered = slice->uncovered;
    m_poses = slice->value.size();
    m_view->setSlice(std::move(shown));
    markCounterexample();
    m_cursor->setText(m_view->cursorText());
    showPose();
    showWords();
}

void CoveragePanel::askWorkspace() {
    if (!hasDevice()) {
        m_assessing.cancel();
        m_sensors->showUncovered({});
        m_placement.reset();
        m_figures->setText({});
        return;
    }
    const auto device = static_cast<models::SphericalDevice>(m_device->currentIndex());
    m_assessing.run([model = model(), device = m_sensors->device(device), placement = m_sensors->placement(),
                     config = config()] { return coverageOfWorkspace(model, device, placement, config); },
                    [this](const Result<CoverageOfWorkspace>& workspace) { takeWorkspace(workspace); });
}

void CoveragePanel::takeWorkspace(const Result<CoverageOfWorkspace>& workspace) {
    if (!workspace) {
        const Error& error = workspace.error();
        m_figures->setText(widgets::inWords(error.message) + QStringLiteral(": ") +
                           widgets::inWords(error.hint));
        return;
    }
    m_sensors->showUncovered(workspace->uncovered);
    m_placement = workspace->figures;
    showFigures();
}

/// The least reading of the lattice, or that of a counterexample, which the proof finds between its poses.
void CoveragePanel::showFigures() {
    if (!m_placement) {
        return;
    }
    double least_T = m_placement->least_T;
    for (const Counterexample& one :
         m_judgement ? m_judgement->counterexamples : std::vector<Counterexample>()) {
        least_T = std::min(least_T, one.largest_T);
    }
    const double conditioning = m_placement->conditioning;
    m_figures->setText(
        tr("Least reading %1 mT, conditioning %2, predicted error %3° rms")
            .arg(widgets::fixedText(1e3 * least_T, decimalsBelow(least_T, m_threshold->value() / 1e3)),
                 conditioning > 0.0 ? widgets::fixedText(conditioning, 3) : tr("none"),
                 widgets::fixedText(radiansToDegrees(m_placement->deviation_rad), 4)));
}

/// The rotor stands in the pose that is read from the map; else in the middle of it.
void CoveragePanel::showPose() {
    if (!hasDevice()) {
        return;
    }
    const QPointF at_deg = m_view->cursor().value_or(QPointF());
    const auto [down, across] = freeAngles(held());
    std::array<double, 3> angles_rad{};
    angles_rad[static_cast<std::size_t>(held())] = degreesToRadians(m_held->value());
    angles_rad[across] = degreesToRadians(at_deg.x());
    angles_rad[down] = degreesToRadians(at_deg.y());
    const models::OrientationAngles angles{angles_rad[0], angles_rad[1], angles_rad[2]};
    m_sensors->showPose(angles, model().readings_T(angles));
}

/// A proof that is no longer asked for ends early.
void CoveragePanel::askJudgement() {
    if (m_isStopped != nullptr) {
        *m_isStopped = true;
    }
    m_isStopped = std::make_shared<std::atomic<bool>>(false);
    m_judgement.reset();
    showWords();
    if (!hasDevice()) {
        m_judging.cancel();
        return;
    }
    m_judging.run(
        [model = model(), threshold_T = m_threshold->value() / 1e3, isStopped = m_isStopped] {
            return judgeCoverage(model, threshold_T, {[isStopped] { return isStopped->load(); }, {}});
        },
        [this](const Result<CoverageJudgement>& judgement) { takeJudgement(judgement); });
}

void CoveragePanel::takeJudgement(const Result<CoverageJudgement>& judgement) {
    if (judgement) {
        m_judgement = *judgement;
    } else {
        m_problem = widgets::inWords(judgement.error().message);
    }
    markCounterexample();
    showFigures();
    showWords();
}

/// In the slice that holds its angle, to the hundredth that the field shows.
void CoveragePanel::markCounterexample() {
    widgets::CoverageSlice slice = m_view->slice();
    slice.marked.reset();
    const auto [down, across] = freeAngles(held());
    for (const Counterexample& one :
         m_judgement ? m_judgement->counterexamples : std::vector<Counterexample>()) {
        const std::array<double, 3> at_deg = anglesOf(one.at);
        if (!slice.marked &&
            hundredths(at_deg[static_cast<std::size_t>(held())]) == hundredths(m_held->value())) {
            slice.marked = QPointF(at_deg[across], at_deg[down]);
        }
    }
    m_view->setSlice(std::move(slice));
}

void CoveragePanel::goToCounterexample() {
    if (m_judgement && !m_judgement->counterexamples.empty()) {
        const std::array<double, 3> at_deg = anglesOf(m_judgement->counterexamples.front().at);
        hold(hundredths(at_deg[static_cast<std::size_t>(held())]));
    }
}

void CoveragePanel::showWords() {
    QStringList words;
    if (m_poses > 0 && hasDevice()) {
        words << tr("%1 of %2 poses of this slice are not covered.")
                     .arg(widgets::countText(m_uncovered), widgets::countText(m_poses));
    }
    m_go->setEnabled(m_judgement && !m_judgement->counterexamples.empty());
    if (!m_problem.isEmpty()) {
        words << m_problem;
    } else if (m_judgement && m_judgement->isProven) {
        words << tr("Proven: all poses of the workspace are covered.");
    }
    for (const Counterexample& one :
         m_judgement ? m_judgement->counterexamples : std::vector<Counterexample>()) {
        const std::array<double, 3> at_deg = anglesOf(one.at);
        const auto number = [&](std::size_t angle) {
            return widgets::numberText(hundredths(at_deg[angle]), 4);
        };
        words << tr("Not covered: (%1, %2, %3)°, where %4 is at most %5 mT.")
                     .arg(number(0), number(1), number(2),
                          QString::fromUtf8(Components[static_cast<std::size_t>(one.component)]),
                          widgets::fixedText(1e3 * one.largest_T,
                                             decimalsBelow(one.largest_T, m_threshold->value() / 1e3)));
    }
    if (hasDevice()) {
        words << tr("Poses are (α, β, γ): %1.").arg(orientationOrderInWords());
    }
    m_verdict->setText(words.join(QLatin1Char(' ')));
}

/// As it is now, not after the dialog: its lines are kept and drawn again.
void CoveragePanel::savePicture() {
    QPicture lines;
    QPainter recorder(&lines);
    m_view->draw(recorder, widgets::paperTheme(), PictureSize_px);
    recorder.end();
    const auto taken = [lines](const QString& path) {
        widgets::Painting painting;
        painting.title = "coverage";
        painting.size = PictureSize_px;
        painting.paint = [lines](QPainter& painter, const widgets::Theme&) {
            QPicture(lines).play(&painter);
        };
        const auto format = widgets::pictureFormat(path).value_or(widgets::PictureFormat::Svg);
        return widgets::pictureWriting(widgets::fileOf(painting, widgets::paperTheme(), format), path);
    };
    app::savePicture(
        this, m_chooser, QStringLiteral("coverage.svg"), m_files, taken, [this](const Error& error) {
            m_problem = widgets::inWords(error.message) + QStringLiteral(": ") + widgets::inWords(error.hint);
            showWords();
        });
}

ActuatorPanel coverageActuatorPanel() {
    return {"coverage",
            QT_TRANSLATE_NOOP("Panels", "Coverage"),
            "monitor.md#coverage",
            boardSensorRoles(),
            [](Workbench& bench) -> QWidget* { return new CoveragePanel(bench); },
            [](QWidget& panel, FileChooser chooser) {
                static_cast<CoveragePanel&>(panel).setFileChooser(std::move(chooser));
            }};
}

} // namespace halbench::app
