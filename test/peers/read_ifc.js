// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// node read_ifc.js FILE.ifc: what web-ifc reads, as JSON: the number of each kind of elements, the area of each space's
// geometry seen from above, and the number of meshes. Its complaints are on stdout, too.
const fs = require('fs');
const web = require('web-ifc');

const kinds = ['IFCBUILDINGSTOREY', 'IFCSPACE', 'IFCSLAB', 'IFCWALL', 'IFCOPENINGELEMENT', 'IFCDOOR', 'IFCWINDOW',
  'IFCSTAIR', 'IFCCOLUMN', 'IFCFURNITURE', 'IFCBUILDINGELEMENTPROXY', 'IFCVIRTUALELEMENT', 'IFCMAPCONVERSION'];

/** Of the triangles that face up; web-ifc turns y up. */
function areaFromAbove(api, model, mesh) {
  let area = 0;
  for (let i = 0; i < mesh.geometries.size(); ++i) {
    const geometry = api.GetGeometry(model, mesh.geometries.get(i).geometryExpressID);
    const v = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
    const t = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
    for (let k = 0; k < t.length; k += 3) {
      const [a, b, c] = [6 * t[k], 6 * t[k + 1], 6 * t[k + 2]];
      area += Math.max(0, (v[b] - v[a]) * (v[c + 1] - v[a + 1]) - (v[b + 1] - v[a + 1]) * (v[c] - v[a])) / 2;
    }
  }
  return area;
}

async function main() {
  const api = new web.IfcAPI();
  await api.Init();
  const model = api.OpenModel(new Uint8Array(fs.readFileSync(process.argv[2])));
  const result = { schema: api.GetModelSchema(model), counts: {}, areas: {}, meshes: 0 };
  for (const kind of kinds)
    result.counts[kind] = api.GetLineIDsWithType(model, web[kind]).size();
  api.StreamAllMeshes(model, () => { ++result.meshes; });
  api.StreamAllMeshesWithTypes(model, [web.IFCSPACE], mesh => {
    const name = api.GetLine(model, mesh.expressID).Name.value;
    result.areas[name.replace('room ', '')] = areaFromAbove(api, model, mesh);
  });
  console.log('RESULT ' + JSON.stringify(result));
}

main();
