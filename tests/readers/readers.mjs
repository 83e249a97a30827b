// Reads a flight's files by the readers that others use: readers.mjs MODULES FLIGHT CORNERS PLACES NAME. It throws if a
// corner of the path is missing, or if Cesium shows another path than the one that was flown.
import assert from "node:assert";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const [modules, flight, cornersFile, placesFile, name] = process.argv.slice(2);
const require = createRequire(modules + "/package.json");
const load = async (what) => import(pathToFileURL(require.resolve(what)));
const rows = (file) => readFileSync(file, "utf8").trim().split("\n").filter(Boolean).map((line) => line.split(" ").map(Number));
const corners = rows(cornersFile);
const text = (ending) => readFileSync(flight + ending, "utf8");

// CSV: papaparse and d3-dsv
const Papa = (await load("papaparse")).default;
const { csvParse } = await load("d3-dsv");
for (const table of [Papa.parse(text(".csv").trimEnd(), { header: true, dynamicTyping: true }).data, csvParse(text(".csv"))])
  for (const [time, , , , x, y, z] of corners)
    assert(table.some((row) => row.shot === name && +row["t [s]"] === time && +row["x [m]"] === x && +row["y [m]"] === y &&
                               +row["z [m]"] === z), `CSV has no row at ${time} s`);

// KML: togeojson
const { kml } = await load("@tmcw/togeojson");
const { DOMParser } = await load("@xmldom/xmldom");
const points = (geometry) =>
  geometry.type === "LineString" ? geometry.coordinates
  : geometry.type === "GeometryCollection" ? geometry.geometries.flatMap(points) : geometry.coordinates.flat();
const map = kml(new DOMParser().parseFromString(text(".kml"), "text/xml"));
const path = map.features.find((feature) => feature.properties.name === name);
assert(path, "no path is named after the shot");
assert(path.properties.timespan.begin.startsWith("2000-01-01T12:00:00"));
const own = JSON.parse(text(".geojson")).features[0];
for (const [time, longitude, latitude, height] of corners)
  for (const [what, geometry] of [["KML", path.geometry], ["GeoJSON", own.geometry]])
    assert(points(geometry).some((p) => p[0] === longitude && p[1] === latitude && p[2] === height),
           `${what} has no point at ${time} s`);
const marks = map.features.filter((feature) => feature.properties.timestamp);
assert(marks.length > 1, "no times at marks");

// CZML: Cesium's own data source
// Cesium expects a browser, of which reading needs next to nothing.
const nothing = () => {};
const node = () => ({ style: {}, getContext: () => null, setAttribute: nothing, appendChild: nothing, addEventListener: nothing });
const location = { href: "http://localhost/", protocol: "http:", host: "localhost" };
globalThis.window ??= Object.assign(globalThis, { location, addEventListener: nothing, CESIUM_BASE_URL: "http://localhost/" });
for (const name of ["Image", "HTMLImageElement", "HTMLCanvasElement", "HTMLVideoElement", "ImageBitmap"]) globalThis[name] ??= class {};
globalThis.document ??= { createElement: node, addEventListener: nothing, getElementsByTagName: () => [], location,
                          documentElement: node(), head: node(), body: node() };
const { CzmlDataSource, Cartesian3, JulianDate } = await load("@cesium/engine");
const source = await CzmlDataSource.load(JSON.parse(text(".czml")));
const entity = source.entities.values[0];
const start = source.clock.startTime, stop = source.clock.stopTime;
const places = rows(placesFile);
assert(Math.abs(JulianDate.secondsDifference(stop, start) - places.at(-1)[0]) < 1e-9, "the clock ends elsewhere");
let farthest = 0;
for (const [time, ...place] of places) {
  const shown = entity.position.getValue(JulianDate.addSeconds(start, time, new JulianDate()));
  assert(shown, `Cesium shows nothing at ${time} s`);
  farthest = Math.max(farthest, Cartesian3.distance(shown, new Cartesian3(...place)));
}
assert(entity.position.getValue(stop), "Cesium shows nothing at the end of its clock");
assert(farthest < 2e-3, `Cesium's path is ${farthest} m off`);
console.log(`farthest ${farthest} m`);
