// SPDX-License-Identifier: MIT
import { defineConfig } from 'vitest/config';
import { licenseComment } from './dev/licenses';
import { slimUplot } from './dev/slim_uplot';

const mock = process.env.ECHOMAP_SERVER ?? 'http://127.0.0.1:8091';

export default defineConfig({
  base: './',
  plugins: [slimUplot()],
  build: {
    outDir: '../built_page',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
    assetsInlineLimit: 0,
    cssCodeSplit: false,
    reportCompressedSize: false,
    rolldownOptions: {
      output: {
        codeSplitting: false,
        entryFileNames: 'app.js',
        assetFileNames: 'app[extname]',
        postBanner: (chunk) => (chunk.isEntry ? licenseComment() : ''),
      },
    },
  },
  server: {
    proxy: {
      '/api': mock,
      '/ws': { target: mock, ws: true },
    },
  },
  test: { include: ['test/**/*.test.ts'] },
});
