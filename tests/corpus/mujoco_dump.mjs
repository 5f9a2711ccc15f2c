// Dumps what MuJoCo compiles of each file named on stdin: one JSON object a line.
import fs from 'node:fs'; import path from 'node:path'; import readline from 'node:readline';
const load = (await import('@mujoco/mujoco')).default;
const mj = await load({print:()=>{},printErr:()=>{}});
const root=process.argv[2];
function mirror(dir){ mj.FS.mkdirTree(dir); for(const e of fs.readdirSync(dir,{withFileTypes:true})){const p=path.join(dir,e.name); if(e.isDirectory()) mirror(p); else if(e.isFile()) mj.FS.writeFile(p, fs.readFileSync(p));}}
const files=fs.readFileSync(0,'utf8').split('\n').filter(Boolean);
mirror(root);
const name=(m,adr)=>{const n=m.names;let s='';for(let i=adr;n[i];i++){s+=typeof n[i]==='string'?n[i]:String.fromCharCode(n[i]);}return s;};
const A=x=>Array.from(x);
for (const file of files) {
  let m;
  try { m = mj.MjModel.from_xml_path ? mj.MjModel.from_xml_path(file) : mj.MjModel.loadFromXML(file); } catch(e) { let t=String(e&&e.message||e); try{ if(typeof e==='number') t=mj.getExceptionMessage(e).join(' ');}catch(_){} console.log(JSON.stringify({file,error:t})); continue; }
  if(!m){console.log(JSON.stringify({file,error:'null'}));continue;}
  try {
  const d = new mj.MjData(m);
  const N=(arr)=>A(arr).map(a=>name(m,a));
  const out={file,body:{name:N(m.name_bodyadr),parent:A(m.body_parentid),mass:A(m.body_mass),ipos:A(m.body_ipos),iquat:A(m.body_iquat),inertia:A(m.body_inertia)},
   joint:{name:N(m.name_jntadr),type:A(m.jnt_type),body:A(m.jnt_bodyid),range:A(m.jnt_range),pos:A(m.jnt_pos),axis:A(m.jnt_axis),stiffness:A(m.jnt_stiffness).slice(0,m.njnt),dof:A(m.jnt_dofadr),qadr:A(m.jnt_qposadr)},
   dof:{damping:A(m.dof_damping).slice(0,m.nv),frictionloss:A(m.dof_frictionloss)},
   geom:{name:N(m.name_geomadr),type:A(m.geom_type),body:A(m.geom_bodyid),size:A(m.geom_size)},qpos:[],xpos:[],xquat:[],gpos:[],gmat:[]};
  let seed=12345; const rnd=()=>{seed=(Math.imul(seed,1103515245)+12345)>>>0;return (seed>>>8)/16777216*2-1;};
  const skip = d.mocap_pos? 0:0;
  for(let k=0;k<20;k++){
    const q=d.qpos; const q0=A(m.qpos0);
    for(let i=0;i<m.nq;i++) q[i]=q0[i];
    if(k) for(let j=0;j<m.njnt;j++){const t=m.jnt_type[j],a=m.jnt_qposadr[j]; if(t>=2) q[a]=rnd();}
    mj.mj_kinematics(m,d);
    out.qpos.push(A(d.qpos)); out.xpos.push(A(d.xpos)); out.xquat.push(A(d.xquat)); out.gpos.push(A(d.geom_xpos)); out.gmat.push(A(d.geom_xmat));
  }
  console.log(JSON.stringify(out)); d.delete(); m.delete();
  } catch(e){console.log(JSON.stringify({file,error:'DUMP '+(e.stack||e)}));}
}
