#include "app/wizards/motion_guide.h"

#include "app/actuators/motion_needs.h"
#include "app/wizards/calibrate_text.h"
#include "app/wizards/live_motion.h"
#include "app/workbench/drive_ability.h"
#include "app/workspaces/field/field_panel.h"
#include "widgets/actuators/actuator_view.h"
#include "widgets/theme/theme_style.h"

#include <QLabel>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

constexpr std::size_t JudgedEvery = 10; ///< a second of rows
constexpr int StaleAfter = 20;          ///< looks, two seconds, without a new row

} // namespace

MotionGuide::MotionGuide(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_numbers = new QLabel(this);
    m_needs = new QLabel(this);
    for (QLabel* label : {m_numbers, m_needs}) {
        label->setWordWrap(true);
        m_column->addWidget(label);
    }
    widgets::setRole(*m_numbers, widgets::Role::Muted);
}

bool MotionGuide::isFor(std::string_view model) const {
    return motionNeedsOf(model) != nullptr;
}

void MotionGuide::choosePicture() {
    const widgets::ActuatorView* view = pictureOf(m_bench.session().catalogue());
    if (view != m_view) {
        delete m_picture;
        m_view = view;
        m_picture = view == nullptr ? nullptr : view->make(this);
        if (m_picture != nullptr) {
            m_column->insertWidget(0, m_picture, 1);
        }
    }
}

void MotionGuide::begin() {
    const bool isByHand = isFor(m_bench.session().info().model);
    m_motion = isByHand ? std::make_shared<LiveMotion>() : nullptr;
    m_judgedRows = 0;
    m_shownRows = 0;
    m_idleLooks = 0;
    m_numbers->clear();
    m_needs->clear();
    if (!isByHand) {
        return;
    }
    choosePicture();
    if (m_picture != nullptr) {
        m_picture->clear();
        m_picture->showWanted({});
        m_picture->setStale(false);
        const auto nothing = [](const std::string&) { return std::optional<double>(); };
        m_picture->showSettings({nothing, [this](const std::string& role) {
                                     return m_bench.deviceValue(
                                         parameterOfRole(m_bench.session().catalogue(), role));
                                 }});
    }
}

void MotionGuide::refresh() {
    if (m_motion == nullptr) {
        return;
    }
    const std::size_t rows = m_motion->rows().rows();
    m_idleLooks = rows == m_shownRows ? m_idleLooks + 1 : 0;
    m_shownRows = rows;
    if (m_picture != nullptr) {
        const auto nothing = [](const std::string&) { return std::optional<double>(); };
        m_picture->setStale(m_idleLooks >= StaleAfter);
        m_picture->showSamples({[this](const std::string& role) {
                                    return m_motion->latest(
                                        signalOfRole(m_bench.session().catalogue(), role));
                                },
                                nothing});
        m_numbers->setText(m_picture->numbers());
    }
    judge();
}

void MotionGuide::judge() {
    const Recording rows = m_motion->rows();
    if (rows.rows() < m_judgedRows + JudgedEvery) {
        return;
    }
    m_judgedRows = rows.rows();
    const MotionNeeds needs = motionNeedsOf(m_bench.session().info().model)(rows, m_bench.deviceValues());
    std::vector<widgets::WantedShaft> wanted;
    for (const ShaftNeed& need : needs.shafts) {
        wanted.push_back({need.theta_rad, need.phi_rad, need.share});
    }
    if (m_picture != nullptr) {
        m_picture->showWanted(wanted);
    }
    m_needs->setText(handMotionNeeds(needs.isEnough, needs.missing, needs.order));
}

} // namespace halbench::app
