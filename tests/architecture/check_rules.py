"""Each rule is shown something wrong, which it must find, and something right, which it must leave alone."""
import os
import re
import unittest

import house
import rules_data
import rules_house
import rules_source
from tree import code_only, function_lengths

RULES = rules_house.RULES | rules_source.RULES | rules_data.RULES
LONG_BODY = "void f(int a) {\n" + "    a++;\n" * 80 + "}\n"
UNITS = 'Unit{"rad", "rad", "angle"},\nUnit{"A/rad", "A_per_rad", "gain"},\n'
BOARD = {"devices/firmware/htm/t.c": '"position" "gain.kp"', "control/base/units.cpp": UNITS}
TEST_OF = {"tests/control/base/a_test.cpp": '#include "control/base/a.h"\n'}


def theme(text, background="#ffffff", **more):
    colours = ", ".join(f'"{k}": "{v}"' for k, v in ({"background": background, "text": text} | more).items())
    return "{" + colours + "}"


def shown(**other):
    """The table of the page, with other lines for some folders."""
    lines = {folder: f"| `{folder}` | holds | {text or 'nothing'} |" for folder, text in house.MAY_INCLUDE.items()}
    return {rules_house.PAGE: "\n".join((lines | {name.replace("__", "/"): line for name, line in other.items()}).values())}


# rule: (wrong trees, right trees)
SAMPLES = {
    "allowed_includes": (
        [{"control/base/a.h": '#include "models/fields/p.h"\n'}, {"control/signals/a.cpp": '#include "control/lti/t.h"\n'},
         {"control/assess/a.h": '#include "control/robustness/r.h"\n'}, {"models/fields/a.h": '#include "models/htm/p.h"\n'},
         {"models/plants/a.h": ""}, {"widgets/a.h": ""}, {"widgets/controls/a.h": '  #  include "devices/device.h"\n'},
         {"widgets/theme/a.h": '#include "devices/transport/transport.h"\n'},
         {"devices/device.h": '#include "app/cli/a.h"\n'}, {"devices/firmware/a.c": '#include "control/base/a.h"\n'},
         {"devices/simulated/a.h": '#include "devices/open/open_device.h"\n'},
         {"devices/xcp/a.cpp": '#include "devices/transport/tcp_transport.h"\n'}, {"devices/a.h": '#include "devices/xcp/a.h"\n'},
         {"app/procedures/a.cpp": '#include "devices/xcp/xcp_master.h"\n'},
         {"app/procedures/base/a.cpp": '#include "app/cli/a.h"\n'},
         {"app/documents/a.cpp": '#include "app/headless/console.h"\n'}, {"app/experiments/a.cpp": '#include "app/cli/a.h"\n'},
         {"app/tuning/a.cpp": '#include "app/cli/a.h"\n'}, {"app/documents/a.cpp": '#include "app/experiments/a.h"\n'},
         {"app/workspaces/device/a.cpp": '#include "devices/simulated/a.h"\n'},
         {"app/experiments/a.cpp": '#include "devices/simulated/a.h"\n'},
         {"app/workspaces/tune/a.cpp": '#include "app/experiments/a.h"\n'}, {"app/cli/a.cpp": '#include "tests/a.h"\n'}],
        [{"control/design/a.h": '#include "control/lti/t.h"\n#include <vector>\n'}, {"devices/xcp/a.h": '#include "devices/transport/transport.h"\n'},
         {"app/procedures/base/a.cpp": '#include "devices/device.h"\n#include "app/procedures/tune/a.h"\n'},
         {"devices/simulated/a.h": '#include "models/htm/p.h"\n'}, {"tests/x/a.cpp": '#include "app/cli/a.h"\n'}]),
    "no_two_folders_include_each_other": (
        [{"a/b/x.h": '#include "a/c/y.h"\n', "a/c/z.cpp": '#include "a/b/x.h"\n'},
         {"a/x.h": '#include "a/b/y.h"\n', "a/b/z.h": '#include "a/x.h"\n'},
         {"a/x.h": '#include "b/y.h"\n', "b/z.h": '#include "c/x.h"\n', "c/y.h": '#include "a/z.h"\n'}],
        [{"a/b/x.h": '#include "a/c/y.h"\n#include "a/b/y.h"\n', "a/c/y.h": '#include <a/b/x.h>\n'},
         {"a/x.h": '#include "b/y.h"\n', "tests/b/z.cpp": '#include "a/x.h"\n'}]),
    "small_actuator_stays_small": (
        [{"tests/conformance/actuator/a.c": "int a;\n" * 251},
         {"tests/conformance/actuator/a.c": "int a;\n" * 200, "tests/conformance/actuator/profiles/a.json": "{}\n" * 51},
         {"tests/conformance/actuator/a.c": "int a; " * 20 + "\n"}],
        [{"tests/conformance/actuator/a.c": "int a;\n" * 250, "tests/conformance/actuator/a_test.cpp": "int a;\n" * 300},
         {"tests/conformance/peer/a.c": "int a;\n" * 300}]),
    "folder_sizes": (
        [{f"control/base/a{i}.h": "" for i in range(61)}],
        [{f"control/base/a{i}.h": "" for i in range(60)}, {f"tests/control/a{i}.cpp": "" for i in range(90)},
         {f"control/{folder}/a{i}.h": "" for i in range(40) for folder in ("base", "lti")}]),
    "page_shows_the_house": (
        [shown(control__lti="| `control/lti` | holds | control/base, law |"), shown(control__lti=""),
         shown(control__base="| `control/base` | holds | control/lti |"), shown(app__other="| `app/other` | holds | nothing |")],
        [shown(), shown(devices="| `devices/*.h` | the interface | control/base | QtCore |"), shown(tests="| `tests` | tests | |")]),
    "allowed_qt": (
        [{"control/base/a.h": "#include <QtCore/QString>\n"}, {"models/fields/a.cpp": "#include <QString>\n"},
         {"devices/xcp/packets.cpp": "#include <QtCore/QFile>\n"}, {"devices/firmware/a.c": "#include <QtCore/QFile>\n"},
         {"app/procedures/a.cpp": "#include <QtWidgets/QWidget>\n"}, {"app/cli/a.cpp": "#include <QWidget>\n"},
         {"devices/acquisition/a.cpp": "#include <qwt_plot.h>\n"}],
        [{"widgets/a.h": "#include <QtWidgets/QWidget>\n#include <QColor>\n#include <qwt_plot.h>\n"},
         {"app/procedures/a.cpp": "#include <QtCore/QFile>\n"}]),
    "panels_run_whole_procedures": (
        [{"app/wizards/a.cpp": '#include "control/identify/fit.h"\n'},
         {"app/workspaces/a.h": '#include "models/estimators/e.h"\n'},
         {"app/window/a.cpp": '#include "app/procedures/identify/identify_fit.h"\n'},
         {"app/wizards/a.cpp": "const auto result = runPlateaus(device, observer, run);"},
         {"app/wizards/a.cpp": "identifyRecording(recording, config);"}],
        [{"app/wizards/a.cpp": '#include "app/procedures/identify/identify_procedure.h"\nreturn runIdentify(device, config, observer);'},
         {"app/wizards/a.cpp": "void P::runStep(int s) { m_session.runProcedure(name, body, then); }"},
         {"app/cli/a.cpp": '#include "app/procedures/identify/identify_fit.h"\nrunMove(device, config, observer);'}]),
    "actuators_stay_in_their_folders": (
        [{"devices/simulated/htm/a.h": "", "devices/open/a.cpp": '#include "devices/simulated/htm/a.h"\n'},
         {"devices/simulated/htm/a.h": "", "devices/simulated/b.cpp": '#include "devices/firmware/htm/hb_htm.h"\n'},
         {"devices/simulated/planar/a.h": "", "app/cli/b.cpp": '#include "app/actuators/planar/p.h"\n'}],
        [{"devices/simulated/htm/a.h": '#include "devices/firmware/htm/hb_htm.h"\n',
          "devices/simulated/registry/simulated_models.cpp": '#include "devices/simulated/htm/a.h"\n',
          "app/actuators/registry/actuators.cpp": '#include "app/actuators/htm/p.h"\n',
          "devices/open/b.cpp": '#include "devices/simulated/simulated_model.h"\n'}]),
    "actuators_are_named_in_their_folders": (
        [{"app/cli/a.cpp": 'const bool isSpecial = model == "planar";'}, {"app/experiments/a.cpp": "planar::step();"},
         {"app/wizards/a.cpp": '#include "widgets/actuators/spherical/sphere_view.h"\n'}],
        [{"app/actuators/planar/a.cpp": 'return {"planar"};', "app/actuators/registry/a.cpp": "planar();",
          "app/cli/a.cpp": "// resources/help/planar-theory.md section 1\nint planarity;"}]),
    "firmware_is_plain_c": (
        [{"devices/firmware/a.c": "#include <stdio.h>\n"}, {"devices/firmware/a.cpp": ""},
         {"devices/firmware/a.c": "p = malloc(4);"}, {"devices/firmware/a.c": 'snprintf (t, 4, "%f", x);'}],
        [{"devices/firmware/a.c": "#include <stdint.h>\n/* malloc( */"}, {"devices/device.cpp": "#include <vector>\n"}]),
    "firmware_has_its_licence": (
        [{"devices/firmware/a.c": "int a;"}, {"devices/firmware/a.h": "\n/* SPDX-License-Identifier: MIT */"}],
        [{"devices/firmware/a.c": "/* SPDX-License-Identifier: MIT */\n"}, {"devices/a.cpp": ""}]),
    "one_type_per_name": (
        [{"a/x.h": "namespace n {\nstruct S { int a; };\n}", "b/y.h": "namespace n {\nstruct S {\n};\n}"},
         {"a/x.h": "namespace n::m { class S final : public B { }; }", "b/y.cpp": "namespace n { namespace m { struct S { }; } }"},
         {"a/x.h": "enum class E { A };", "b/y.h": "enum class E : int { B };"},
         {"a/x.h": "struct O { struct S { }; };", "b/y.h": "struct O;\nstruct O { };"}],
        [{"a/x.h": "namespace n { struct S { }; struct F; }", "b/y.h": "namespace m { struct S { }; }\nnamespace n { struct F { }; }"},
         {"a/x.cpp": "namespace {\nstruct S { };\n}", "b/y.cpp": "namespace {\nstruct S { };\n}"},
         {"a/x.cpp": "void f() { struct S { }; }", "b/y.cpp": "void g() { struct S { }; } // struct f { }"},
         {"a/x.h": "struct A { struct S { }; };", "b/y.h": "struct B { struct S { }; };"}]),
    "file_sizes": ([{"control/base/a.cpp": "\n" * 601}], [{"control/base/a.cpp": "\n" * 600}, {"README.md": "\n" * 900}]),
    "function_sizes": (
        [{"a.cpp": LONG_BODY}, {"a.cpp": "namespace a {\nclass B {\n" + LONG_BODY + "};\n}\n"},
         {"a.cpp": LONG_BODY.replace("(int a)", "(int a = 3) const noexcept")},
         {"a.cpp": LONG_BODY.replace("a++;", "if (a) { a--; }")},
         {"a.cpp": LONG_BODY.replace("void f(int a)", "F::F(int a) : m_a{a}, m_b(a)")},
         {"a.cpp": LONG_BODY.replace("void f(int a)", "F::F(int a) : m_a{a}")}],
        [{"a.cpp": LONG_BODY.replace("    a++;\n", "", 2)}, {"a.cpp": "const int t[] = {\n" + "1,\n" * 90 + "};\n"},
         {"a.cpp": "namespace a {\n" + "int f() { return 1; }\n" * 90 + "}\n"}]),
    "forbidden_words": (
        [{"a.cpp": "connect(a, SIGNAL(b()), c, SLOT(d()));"}, {"app/a.cpp": "w->setStyleSheet(x);"},
         {"tests/a.cpp": "std::this_thread::sleep_for(1ms);"}, {"tests/a.cpp": "TEST(A, DISABLED_b) {}"},
         {"tests/a.cpp": "GTEST_SKIP();"}, {"a.cpp": "std::normal_distribution<double> d;"}, {"a.cpp": "std::random_device r;"},
         {"a.cpp": "auto n = std::chrono::system_clock::now();"}, {"a.cpp": 'std::format("{}", 1);'},
         {"a.cpp": "std::views::iota(1);"}, {"a.h": "using namespace std;"}, {"a.cpp": "assert(a == b);"},
         {"a.cpp": "static int counter = 0;"}, {"a.cpp": "int r = rand();"},
         {"app/a.cpp": "path = QFileDialog::getOpenFileName(this);"}],
        [{"widgets/theme/theme.cpp": "w->setStyleSheet(x);"}, {"a.cpp": "// sleep_for GTEST_SKIP\nconst char* t = \"std::format\";"},
         {"a.cpp": "static_assert(true); static const int a = 1; static constexpr int b = 2;"},
         {"a.cpp": "static int twice(int a) { return 2 * a; }"}, {"a.cpp": "connect(a, &A::b, this, &B::c);"},
         {"a.cpp": "using namespace halbench::control;"}, {"a.cpp": "HB_ASSERT(a == b);"}]),
    "nothing_unfinished": ([{"a.cpp": "int a; // TODO later"}, {"a.h": "/* FIXME */"}],
                           [{"a.cpp": "// TODO(#12): the other axis"}, {"a.cpp": "int TODO;"}]),
    "names_and_guards": ([{"control/base/MyFile.cpp": ""}, {"control/base/a-b.cpp": ""}, {"control/base/a.h": "int a;\n"}],
                         [{"control/base/my_file.h": "#pragma once\n"}, {"devices/a.h": "#ifndef A_H\n#define A_H\n"}]),
    "cites_only_what_is_here": (
        [{"a.h": "// see physics/htm.md"}, {"README.md": "see ../shared/a"}, {"a.h": "// design.md section 1"},
         {"resources/x.toml": "# cli.md"}, {"dev": "cd /home/someone/project"}, {"a.cpp": "// style.md 7"}],
        [{"a.h": "// resources/help/protocol.md 3.5"}, {"a.h": "// astrophysics/ and metaphysics"},
         {"a.cpp": "// command-line.md, my_design.mdx"}]),
    "one_source_per_class": (
        [{"app/window/a.cpp": "void Panel::show() {}\n", "app/window/a_more.cpp": "Panel::~Panel() = default;\n"},
         {f"app/window/main_{i}.cpp": "int MainWindow::f(int a) {\n}\n" for i in range(5)}],
        [{"app/window/a.cpp": "void Panel::show() {}\n", "app/window/b.cpp": "void g() {\n    Panel::show();\n}\n"},
         {"app/window/a.cpp": "void Panel::show() {}\n", "app/tune/a.cpp": "void Panel::show() {}\n"},
         {"app/window/a.cpp": "void Panel::show() {}\n", "tests/a.cpp": "void Panel::show() {}\n"},
         {f"app/window/main_{i}.cpp": "int MainWindow::f(int a) {\n}\n" for i in range(4)}]),
    "every_source_has_its_test": (
        [{"control/base/a.cpp": "", "control/base/a.h": ""}, {"control/base/b.cpp": ""},
         {"control/base/a.cpp": "", "control/base/a.h": "", "tests/t.md": '#include "control/base/a.h"'},
         TEST_OF | {"control/base/b.cpp": "", "control/base/b.h": "", "control/base/a.h": ""},
         {"tests/x/a_test.cpp": '#include "control/lti/a.h"\n', "control/lti/a.h": '#include "control/base/b.h"\n',
          "control/base/b.h": "", "control/base/b.cpp": ""}],
        [TEST_OF | {"control/base/a.cpp": "", "control/base/a.h": ""},
         TEST_OF | {"control/base/a_part.cpp": '#include "control/base/a.h"\n', "control/base/a.h": ""},
         TEST_OF | {"control/base/a.h": "", "control/base/a.cpp": '#include "control/base/part.h"\n',
                    "control/base/part.h": "", "control/base/part.cpp": ""}]),
    "data_parses": (
        [{"resources/a.json": "{"}, {"resources/a.json": '{"a": NaN}'}, {"resources/a.json": '{"a": 1, "a": 2}'},
         {"resources/a.toml": "a = "}, {"resources/a.toml": "a = 1\na = 2"}],
        [{"resources/a.json": '{"a": 1}', "resources/b.toml": "a = 1", "resources/c.md": "{"}]),
    "profile_roles_exist": (
        [BOARD | {"resources/devices/m.json": '{"signal_roles": {"position": "positon"}}'},
         BOARD | {"resources/devices/m.json": '{"parameter_roles": {"gain.kp": "gain.kq"}}'},
         BOARD | {"resources/devices/m.json": '{"default_signals": ["speed"]}'}],
        [BOARD | {"resources/devices/m.json": '{"signal_roles": {"p": "position"}, "default_signals": ["position"]}'}]),
    "preset_keys_exist": (
        [BOARD | {"resources/devices/m.json": '{"presets": {"published": {"gain.kx": 1}}}'},
         BOARD | {"resources/devices/m.json": '{"presets": [{"name": "a", "values": {"kp": 1}}]}'}],
        [BOARD | {"resources/devices/m.json": '{"presets": {"published": {"gain.kp": 1}}}'}]),
    "units_are_known": (
        [BOARD | {"resources/devices/m.json": '{"a": [{"unit": "furlong"}]}'}],
        [BOARD | {"resources/devices/m.json": '{"a": [{"unit": "A/rad"}]}'},
         BOARD | {"resources/schemas/m.json": '{"unit": "string"}'}]),
    "unit_suffixes_are_unique": (
        [{"control/base/units.cpp": 'Unit{"A", "A/s", ""},'}, {"control/base/units.cpp": UNITS + UNITS}],
        [{"control/base/units.cpp": UNITS}]),
    "themes_are_complete": (
        [{"resources/themes/a.json": theme("#000000"), "resources/themes/b.json": theme("#000000", grid="#888888")},
         {"resources/themes/a.json": theme("#999999")}],
        [{"resources/themes/a.json": theme("#000000"), "resources/themes/b.json": theme("#eeeeee", "#101010")}]),
    "help_links_lead_somewhere": (
        [{"resources/help/a.md": "[b](b.md)"}, {"resources/help/a.md": "[b](#none)"},
         {"resources/help/a.md": "[b](b.md#two)", "resources/help/b.md": "# One"}],
        [{"resources/help/a.md": "[b](b.md#one-more) [c](https://x.y)", "resources/help/b.md": "## One more"},
         {"README.md": "[h](resources/help)", "resources/help/a.md": ""}]),
    "citations_exist": (
        [{"a.h": "// resources/help/tuning.md"}, {"a.h": "// htm-theory.md 3.9", "resources/help/htm-theory.md": "### 3.1 A"}],
        [{"a.h": "// resources/help/htm-theory.md 3.1 and 6.10", "resources/help/htm-theory.md": "### 3.1 A\n| 6.10 | x |"},
         {"a.h": "// htm-theory.md, section 3", "resources/help/htm-theory.md": "## 3. Equations"}]),
}


class Rules(unittest.TestCase):
    def test_every_rule_has_its_samples(self):
        self.assertEqual(set(SAMPLES), set(RULES))

    def test_every_rule_is_run(self):
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "CMakeLists.txt"), encoding="utf-8") as file:
            listed = re.search(r"set\(rules(.*?)\)", file.read(), re.S).group(1).split()
        self.assertEqual(sorted(listed), sorted(RULES))

    def test_wrong_samples_are_found(self):
        for name, (wrong, _) in SAMPLES.items():
            for sample in wrong:
                with self.subTest(rule=name, sample=str(sample)[:200]):
                    self.assertTrue(list(RULES[name](sample)))

    def test_right_samples_are_left_alone(self):
        for name, (_, right) in SAMPLES.items():
            for sample in right:
                with self.subTest(rule=name, sample=str(sample)[:200]):
                    self.assertEqual(list(RULES[name](sample)), [])

    def test_every_folder_of_the_house_refuses_something(self):
        for folder in house.MAY_INCLUDE:
            sample = {f"{folder}/a.cpp": '#include "tests/a.h"\n'}
            self.assertTrue(list(rules_house.allowed_includes(sample)), folder)

    def test_the_house_has_no_cycles_and_names_its_own_folders(self):
        arrows = {folder: house.folders_in(text) for folder, text in house.MAY_INCLUDE.items()}
        self.assertEqual(house.cycles(arrows), [])
        for folder, others in arrows.items():
            self.assertLessEqual(others, set(arrows), folder)


class Reading(unittest.TestCase):
    def test_comments_and_literals_are_blanked_in_place(self):
        text = 'int a; // x\nconst char* t = "y\\"z"; /* a\nb */ char c = \'{\'; int n = 1\'000;\n'
        blanked = code_only(text)
        self.assertEqual(len(blanked), len(text))
        self.assertEqual(blanked.count("\n"), text.count("\n"))
        for word in ("x", "y", "z", "{"):
            self.assertNotIn(word, blanked.replace("const char", ""))

    def test_functions_are_measured_from_brace_to_brace(self):
        text = "namespace n {\nstruct S {\n  int m() const {\n    return 1;\n  }\n};\nS::S() : a(1), b{2} {\n}\n}\n"
        self.assertEqual([length for _, length in function_lengths(text)][:1], [3])

    def test_contrast_of_black_and_white_is_21(self):
        self.assertAlmostEqual(rules_data.contrast("#000000", "#ffffff"), 21.0)


if __name__ == "__main__":
    unittest.main()
