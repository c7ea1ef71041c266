"""The folders of the house and what each may include. The table of resources/help/architecture.md, section 1, is its picture."""

# folder: the folders that it may include besides itself; sub-folders belong to it. "control/base, lti" is two folders;
# "devices" alone means the headers directly in it. Whatever is not named is forbidden.
MAY_INCLUDE = {
    "control/base": "",
    "control/lti": "control/base",
    "control/analysis": "control/base, lti",
    "control/law": "control/base, lti, analysis",
    "control/assess": "control/base, lti, analysis, law",
    "control/robustness": "control/base, lti, analysis, law, assess",
    "control/design": "control/base, lti, analysis, law, assess",
    "control/signals": "control/base",
    "control/history": "control/base, signals",
    "control/identify": "control/base",
    "models/fields": "control/base",
    "models/sensors": "control/base",
    "models/drives": "control/base",
    "models/thermal": "control/base",
    "models/estimators": "control/base",
    "models/htm": "control/base, law, assess; models/sensors, drives, thermal",
    "models/planar": "control/base; models/fields, sensors, drives, thermal",
    "models/spherical": "control/base; models/fields, sensors, drives, thermal",
    "devices": "control/base",
    "devices/firmware": "",
    "devices/transport": "control/base",
    "devices/xcp": "control/base; devices; devices/transport",
    "devices/recording": "control/base; devices",
    "devices/acquisition": "control/base; devices; devices/recording",
    "devices/formats": "control/base; devices; devices/recording, acquisition",
    "devices/history": "control/base",
    "devices/simulated": "control/base; models/htm, planar, spherical; devices; devices/firmware, transport, xcp",
    "devices/open": "control/base; devices; devices/firmware, transport, xcp, simulated, formats",
    "widgets/theme": "control/base",
    "widgets/language": "control/base",
    "widgets/raster": "control/history",
    "widgets/controls": "control/base; widgets/theme, language",
    "widgets/log": "widgets/theme, language, controls",
    "widgets/parameters": "control/base; widgets/theme, language, controls",
    "widgets/figure": "control/base; widgets/theme, language, raster",
    "widgets/live_plot": "control/history; widgets/theme, language, raster, controls",
    "widgets/spectrogram": "control/base; widgets/theme, language, figure, live_plot",
    "widgets/actuators": "control/base; models/fields, planar, spherical; widgets/theme, language",
    "app/procedures": "control/base, lti, analysis, law, assess, robustness, design, signals, history, identify; models/htm, thermal; "
                      "devices; devices/recording, acquisition",
    "app/actuators": "control/base, identify, design; models/fields, sensors, drives, estimators, htm, planar, spherical; devices; devices/simulated; app/procedures",
    "app/session": "control/base; devices; devices/recording, acquisition, open; app/procedures",
    "app/documents": "control/base, lti, law, assess, design, signals, identify; devices; devices/recording, formats; "
                     "app/procedures, actuators",
    "app/analyses": "control/base; models/fields, planar, spherical; devices/formats; app/procedures, actuators, documents",
    "app/recordings": "control/base; devices; devices/recording, formats; app/documents",
    "app/tuning": "control/base; devices; devices/formats; app/procedures, documents",
    "app/figures": "control/base, lti, analysis, identify; widgets/theme, language, figure; app/procedures, analyses",
    "app/report": "control/base; models/htm; widgets/theme, figure; app/procedures, actuators, figures",
    "app/headless": "control/base; devices; devices/transport, recording, formats, open; app/procedures, documents, analyses",
    "app/experiments": "control/base; devices/recording, formats; app/procedures, actuators, analyses, documents, tuning, figures, report, headless",
    "app/cli": "control/base, design, signals; devices; devices/recording, acquisition, formats, open; "
               "app/procedures, actuators, analyses, documents, recordings, tuning, figures, headless, experiments",
    "app/workbench": "control/base, signals, history; devices; devices/recording, acquisition, formats, history; "
                     "widgets/language, controls, figure; app/procedures, actuators, session, documents, recordings",
    "app/workspaces": "control/base, analysis, law, design, signals, history; devices; devices/recording, acquisition, formats, open; "
                      "widgets/theme, language, raster, controls, log, parameters, figure, live_plot, spectrogram, actuators; "
                      "app/procedures, documents, recordings, tuning, figures, workbench",
    "app/workspaces/actuators": "control/base; models/spherical; devices; widgets/theme, language, controls, figure, actuators; "
                                "app/actuators, analyses, workbench, workspaces",
    "app/wizards": "control/base; devices; widgets/theme, language, controls, figure, actuators; "
                   "app/procedures, actuators, documents, tuning, figures, workbench, workspaces",
    "app/window": "control/base; devices/history, open; widgets/theme, language, controls; "
                  "app/procedures, documents, recordings, headless, workbench, workspaces, workspaces/actuators, wizards",
    "app/program": "app/headless, cli, window",
}

# Of these folders only the headers that match may be included: links are opened through the interface.
ONLY_HEADERS = {("devices/xcp", "devices/transport"): r"devices/transport/transport\.h"}


def folders_in(text):
    """"control/base, lti; devices" -> control/base, control/lti, devices."""
    found = set()
    for group in filter(None, text.split("; ")):
        names = group.split(", ")
        parent = names[0].rpartition("/")[0]
        found |= {names[0]} | {f"{parent}/{name}" for name in names[1:]}
    return found


def folder_of(path):
    """The folder of the table that a file belongs to, None for one of no folder."""
    place = path.rpartition("/")[0]
    while place and place not in MAY_INCLUDE:
        place = place.rpartition("/")[0]
    # Directly in `devices` lies its interface; a new folder beside the others has to be named.
    return place if place and (place != "devices" or path.count("/") == 1) else None


def cycles(arrows):
    """Groups of folders that include each other, over however many others; `arrows`: folder -> folders."""
    reached = {folder: reachable(folder, arrows) for folder in arrows}
    groups = {frozenset(other for other in reached[folder] if folder in reached.get(other, ())) for folder in arrows}
    return sorted(sorted(group) for group in groups if group)


def reachable(folder, arrows):
    found, waiting = set(), list(arrows.get(folder, ()))
    while waiting:
        place = waiting.pop()
        if place not in found:
            found.add(place)
            waiting += arrows.get(place, ())
    return found
