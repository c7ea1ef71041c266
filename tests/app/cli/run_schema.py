"""Writes resources/schemas/run.schema.json from the schemas of the single results.

    python3 run_schema.py resources            says whether the published file is that
    python3 run_schema.py resources --write    writes it

A step of a run holds what its command writes, without the header that the whole run has. So its schema
comes from that of the command; only the parts that no command writes alone are listed here.
"""
import copy
import json
import os
import sys

HEADER = ("schema", "halbench", "device", "started", "seed")
NUMBER = {"type": "number"}
NUMBER_OR_NULL = {"type": ["number", "null"]}
TEXT = {"type": "string"}


def table(properties, optional=()):
    return {"type": "object", "required": [key for key in properties if key not in optional], "additionalProperties": False,
            "properties": properties}


def analysed_parts():
    """Subjects of `analyse` that only a run has."""
    amplifier = table({"gain_A_per_V": NUMBER, "lag_at_10hz_deg": NUMBER, "cutoff_hz": NUMBER_OR_NULL, "magnitude_at_1khz_db": NUMBER,
                       "phase_at_1khz_deg": NUMBER, "shunt_power_W": NUMBER, "shunt_power_each_W": NUMBER},
                      optional=("shunt_power_W", "shunt_power_each_W"))
    figures = {"type": "object", "additionalProperties": table({"value": NUMBER_OR_NULL, "unit": TEXT})}
    return [amplifier, table({"what": {"enum": ["torque", "sensing", "poles", "field", "coil"]}, "figures": figures})]


def repetition(unit):
    """Of a move with `repeat`, positions in that unit."""
    run = {key + unit: NUMBER_OR_NULL for key in ("start_", "max_error_", "peak_to_peak_")} | {"settling_time_s": NUMBER_OR_NULL}
    times = table({"count": {"type": "integer", "minimum": 1}} | {
        key: NUMBER for key in ("least_s", "median_s", "mean_s", "deviation_s", "largest_s")})
    times |= {"type": ["object", "null"], "description": "of the runs that came to rest within the limit"}
    body = {"count": {"type": "integer", "minimum": 1}, "settled_" + unit: NUMBER_OR_NULL, "alternate": {"type": "boolean"},
            "settled_fraction": NUMBER_OR_NULL, "settling_time": times}
    body |= {key + unit: NUMBER_OR_NULL for key in ("least_peak_to_peak_", "median_peak_to_peak_", "largest_peak_to_peak_")}
    body["runs"] = {"type": "array", "items": table(run)}
    return table(body) | {"description": "of a move with repeat; the figures beside it are those of the last run"}


class Composer:
    def __init__(self, resources):
        self.resources = resources
        self.published = self.schema("run")
        self.quality = self.published["properties"]["data_quality"]

    def schema(self, name):
        with open(os.path.join(self.resources, "schemas", f"{name}.schema.json"), encoding="utf-8") as file:
            return json.load(file)

    def step(self, kind, body):
        """A body with the members of every step in front."""
        body = copy.deepcopy(body)
        own = {key: value for key, value in body["properties"].items() if key != "data_quality"}
        required = [key for key in body["required"] if key != "data_quality"]
        step = {"type": "object", "required": ["name", "kind", "data_quality", *required]}
        if "additionalProperties" in body:
            step["additionalProperties"] = body["additionalProperties"]
        step["properties"] = {"name": TEXT, "kind": {"const": kind}, "data_quality": self.quality, **own}
        return step

    def result(self, kind, schema, without=()):
        """What a command writes, without its header and without members of that command alone."""
        left_out = HEADER + tuple(without)
        body = dict(schema)
        body["properties"] = {key: value for key, value in schema["properties"].items() if key not in left_out}
        body["required"] = [key for key in schema["required"] if key not in left_out]
        return self.step(kind, body)

    def moves(self):
        move = self.schema("move")["properties"]
        one = copy.deepcopy(move["figures"])
        one["properties"]["repetition"] = repetition("deg")
        of_unit = {"oneOf": [repetition(unit) for unit in ("m", "rad")]}
        several = table({"axes": move["axes"], "contour": move["contour"], "repetition": of_unit}, optional=("contour", "repetition"))
        return [self.step("move", one), self.step("move", several)]

    def steps(self):
        gains, analysis = self.schema("gains")["anyOf"], self.schema("analysis")["anyOf"]
        kinds = [self.result("identify", self.schema(name)) for name in ("identification", "axis-model")]
        kinds += [self.result("frequency", self.schema(name)) for name in ("frequency", "axis-frequency")]
        kinds += [self.result("relay", self.schema("relay")), self.result("calibrate", self.schema("calibration"))]
        kinds += [self.result("tune", each, without=("applied",)) for each in gains]
        kinds.append(self.result("analyse", analysis[0], without=("compared", "what_if")))
        kinds += [self.step("analyse", part) for part in analysed_parts()]
        live = ("planned_steps", "steps")
        kinds += [self.result("apply", each["properties"]["applied"], without=live) for each in gains]
        kinds += self.moves()
        kinds.append(self.result("record", self.schema("recorded"), without=("file", "coil_forecast")))
        written = {"type": "array", "items": table({"name": TEXT, "value": NUMBER})}
        kinds.append(self.step("set", table({"values": written})))
        kinds.append(self.step("wait", table({"duration_s": NUMBER})))
        analyses = {"forces": "forces", "coverage": "coverage", "differences": "differences", "estimators": "estimators", "field": "field",
                    "orient": "orientation", "place": "placement", "readings": "readings", "swarm": "swarm"}
        kinds += [self.result(kind, self.schema(name)) for kind, name in analyses.items()]
        return kinds

    def run(self):
        run = copy.deepcopy(self.published)
        run["properties"]["steps"]["items"]["oneOf"] = self.steps()
        return run


def path_of(resources):
    return os.path.join(resources, "schemas", "run.schema.json")


def composed(resources):
    return json.dumps(Composer(resources).run(), indent=2, ensure_ascii=False) + "\n"


def main(resources, *options):
    text = composed(resources)
    if "--write" in options:
        with open(path_of(resources), "w", encoding="utf-8") as file:
            file.write(text)
        return 0
    with open(path_of(resources), encoding="utf-8") as file:
        return 0 if file.read() == text else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
