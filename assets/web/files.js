// Under node, the files of the program are those of the disk. In a browser they are those that a page gives it.
if (ENVIRONMENT_IS_NODE && !ENVIRONMENT_IS_WORKER) {
  Module['preRun'] = [].concat(Module['preRun'] || [], () => {
    const disk = require('fs');
    for (const folder of disk.readdirSync('/', {withFileTypes: true})) {
      if (!folder.isDirectory() || ['dev', 'proc', 'sys'].includes(folder.name)) continue;
      FS.mkdirTree('/' + folder.name);
      FS.mount(NODEFS, {root: '/' + folder.name}, '/' + folder.name);
    }
    FS.chdir(process.cwd());
  });
}
