#include "app/workspaces/tune/axes/axis_loops.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/axis_conditions.h"
#include "app/tuning/gains_judgement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

/// Values by the bare roles of one axis ("gain.kp"), as a law is read from them.
std::map<std::string, double> valuesOfAxis(const devices::Catalogue& catalogue,
                                           const std::map<std::string, double>& values) {
    std::map<std::string, double> byRole;
    for (const ParameterSpec& parameter : catalogue.parameters) {
        const auto value = values.find(parameter.name);
        if (!parameter.role.empty() && value != values.end()) {
            byRole[parameter.role] = value->second;
        }
    }
    return byRole;
}

} // namespace

Result<AxisAnswer> answerAxis(const AxisQuestion& question) {
    TuneAxesConfig config;
    config.method = question.choice.method;
    config.targets = question.choice.targets;
    auto result = question.choice.law ? judgeAxes(question.model, {question.conditions},
                                                  {*question.choice.law}, {question.choice.method}, config)
                                      : tuneAxes(question.model, {question.conditions}, config);
    if (!result) {
        return failure(result.error());
    }
    AxisAnswer answer{std::move(result->axes.front()), {}};
    if (question.present) {
        auto present =
            judgeAxes(question.model, {question.conditions}, {*question.present}, {"device"}, config);
        if (present) {
            answer.present = std::move(present->axes.front().predicted);
        }
    }
    return answer;
}

void AxisLoops::setModel(AxisModelFile model) {
    m_model = std::move(model);
    m_choices.clear();
    m_answers.clear();
    m_conditions.clear();
    m_present.clear();
    if (auto conditions = axisConditionsOf(*m_model, axes())) {
        for (LoopConditions& each : *conditions) {
            m_conditions[each.axis->id] = each;
        }
    }
}

Result<std::vector<std::string>> AxisLoops::readDevice(const devices::Catalogue& catalogue,
                                                       const std::map<std::string, double>& values) {
    std::vector<std::string> changed;
    if (!m_model) {
        return changed;
    }
    auto conditions = axisConditionsOf(catalogue, values, axes());
    if (!conditions) {
        return failure(conditions.error());
    }
    for (LoopConditions& each : *conditions) {
        const std::string id = each.axis->id;
        const auto axis = chosenAxis(catalogue, id);
        const auto law = axis ? loopLawFromParameters(valuesOfAxis(catalogueOfAxis(catalogue, *axis), values),
                                                      each.timing.period_s)
                              : failure(axis.error());
        const std::optional<LoopLaw> runs = law ? std::optional(*law) : std::nullopt;
        const auto before = m_conditions.find(id);
        if (before == m_conditions.end() || !(before->second == each) || !(present(id) == runs)) {
            changed.push_back(id);
        }
        m_conditions[id] = std::move(each);
        m_present.erase(id);
        if (runs) {
            m_present.emplace(id, *runs);
        }
    }
    return changed;
}

std::vector<std::string> AxisLoops::axes() const {
    std::vector<std::string> names;
    for (const IdentifiedAxis& axis : m_model ? m_model->model.axes : std::vector<IdentifiedAxis>()) {
        names.push_back(axis.axis);
    }
    return names;
}

std::optional<LoopLaw> AxisLoops::present(const std::string& axis) const {
    const auto found = m_present.find(axis);
    return found == m_present.end() ? std::nullopt : std::optional(found->second);
}

std::optional<AxisQuestion> AxisLoops::question(const std::string& axis) const {
    const auto conditions = m_conditions.find(axis);
    if (!m_model || conditions == m_conditions.end()) {
        return std::nullopt;
    }
    const auto choice = m_choices.find(axis);
    return AxisQuestion{m_model->model, conditions->second,
                        choice == m_choices.end() ? AxisChoice{} : choice->second, present(axis)};
}

void AxisLoops::setAnswer(const std::string& axis, Result<AxisAnswer> answer) {
    m_answers.insert_or_assign(axis, std::move(answer));
}

const Result<AxisAnswer>* AxisLoops::answer(const std::string& axis) const {
    const auto found = m_answers.find(axis);
    return found == m_answers.end() ? nullptr : &found->second;
}

std::optional<control::CrossoverAim> AxisLoops::aim(const std::string& axis) const {
    const Result<AxisAnswer>* known = answer(axis);
    if (known == nullptr || !*known) {
        return std::nullopt;
    }
    const TuneResult& proposed = (*known)->proposed;
    return control::crossoverAimOf(proposed.plant, proposed.conditions.timing, proposed.law.gains,
                                   proposed.filtered.value_or(control::FilteredLaw{}));
}

Result<control::CrossoverDesign> AxisLoops::filtered(const std::string& axis,
                                                     const control::CrossoverAim& aim,
                                                     control::CrossoverPriority priority) const {
    const Result<AxisAnswer>* known = answer(axis);
    if (known == nullptr || !*known) {
        return failure(ErrorCode::Refused, "there is no loop to shape yet", "choose a method first");
    }
    const TuneResult& proposed = (*known)->proposed;
    return control::designCrossover(proposed.plant, proposed.conditions.timing, aim, priority,
                                    proposed.filtered.value_or(control::FilteredLaw{}));
}

std::optional<MeasuredLoop> AxisLoops::measured(const std::string& axis) const {
    const auto plant = m_measured.find(axis);
    const Result<AxisAnswer>* known = answer(axis);
    if (plant == m_measured.end() || known == nullptr || !*known) {
        return std::nullopt;
    }
    const TuneResult& proposed = (*known)->proposed;
    const auto loop = measuredLoop(plant->second, asFiltered(LoopLaw(proposed.law, proposed.filtered)),
                                   proposed.conditions.timing);
    return loop ? std::optional(*loop) : std::nullopt;
}

Result<std::map<std::string, MeasuredPlant>> AxisLoops::plantsOf(const AxesFrequencyFile& file) const {
    if (!m_model) {
        return failure(ErrorCode::Refused, "no axes were identified", "identify the axes first");
    }
    const auto& identified = m_model->header.device;
    if (file.header.device && identified && file.header.device->model != identified->model) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the response is of a device '{}', the model is of a '{}'",
                                   file.header.device->model, identified->model),
                       "open a response of this kind of device");
    }
    auto plants = plantsFor(m_model->model, file);
    if (!plants) {
        return plants;
    }
    for (const auto& [axis, plant] : *plants) {
        const auto asked = question(axis);
        const double period_s = asked ? asked->conditions.timing.period_s : plant.period_s;
        if (std::abs(plant.period_s - period_s) > 1e-9 * period_s) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("sampling period of the response {:.4g} ms, of this loop {:.4g} ms",
                                       1e3 * plant.period_s, 1e3 * period_s),
                           "measure the response on this device");
        }
    }
    return plants;
}

/// Gains of another sampling period are another law.
Result<void> AxisLoops::checkPeriods(const AxisGainsFile& file) const {
    for (std::size_t i = 0; i < file.axes.size(); ++i) {
        const auto conditions = m_conditions.find(file.axes[i]);
        const auto same = conditions == m_conditions.end()
                              ? Result<void>()
                              : checkPeriodOfGains(file.gains[i].timing, conditions->second.timing);
        if (!same) {
            return failure(same.error().code, fmt::format("axis {}: {}", file.axes[i], same.error().message),
                           same.error().hint);
        }
    }
    return {};
}

Result<std::vector<std::string>> AxisLoops::takeGains(const AxisGainsFile& file) {
    const auto& identified = m_model->header.device;
    if (file.device && identified && file.device->model != identified->model) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the gains are for a device '{}', the model is of a '{}'",
                                   file.device->model, identified->model),
                       "open gains that were found with a model of this kind of device");
    }
    if (const auto fits = checkPeriods(file); !fits) {
        return failure(fits.error());
    }
    std::vector<std::string> missing;
    for (const std::string& axis : axes()) {
        const auto found = std::find(file.axes.begin(), file.axes.end(), axis);
        if (found == file.axes.end()) {
            missing.push_back(axis);
            continue;
        }
        AxisChoice& choice = m_choices[axis];
        choice.method = "edited";
        choice.targets = {};
        choice.law = file.gains[static_cast<std::size_t>(found - file.axes.begin())].loopLaw();
    }
    if (missing.size() == axes().size()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the gains are for axes {}, the model has {}", fmt::join(file.axes, ", "),
                                   fmt::join(axes(), ", ")),
                       "open gains for an axis of the model");
    }
    return missing;
}

Result<TuneAxesResult> AxisLoops::result(const std::vector<std::string>& wanted) const {
    TuneAxesResult all;
    for (const std::string& axis : wanted) {
        const Result<AxisAnswer>* known = answer(axis);
        if (known == nullptr) {
            return failure(ErrorCode::Refused, "the loop of axis " + axis + " is still computed",
                           "wait until its verdict is there");
        }
        if (!*known) {
            return failure(known->error().code, "axis " + axis + ": " + known->error().message,
                           known->error().hint);
        }
        const TuneResult& proposed = (*known)->proposed;
        all.quality.verdict = std::max(all.quality.verdict, proposed.quality.verdict);
        for (const Finding& finding : proposed.warnings) {
            all.quality.findings.push_back(
                {finding.code, "axis " + axis + ": " + finding.message, finding.hint});
        }
        all.axes.push_back(proposed);
    }
    return all;
}

} // namespace halbench::app
